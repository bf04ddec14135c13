#include "schedule.hpp"

namespace codend {

ScheduledValues values_at(const Schedule& schedule, double time, Side side) {
  ScheduledValues out;
  const PrescribedMotion& motion = schedule.motion;
  if (!motion.x.time.empty()) {
    motion.x.at(time, side, out.origin.x(), out.velocity.x());
    motion.y.at(time, side, out.origin.y(), out.velocity.y());
    motion.z.at(time, side, out.origin.z(), out.velocity.z());
    motion.heading.at(time, side, out.heading, out.turning);
  }
  for (const GrowingGroup& group : schedule.growing) {
    double factor, rate;
    if (group.controlled) {
      factor = group.control.length_at(time) / group.control.full_length;
      rate = group.control.speed / group.control.full_length;
    } else {
      group.factor.at(time, side, factor, rate);
    }
    out.factor.push_back(factor);
    out.rate.push_back(rate);
  }
  for (std::size_t k = 0; k < schedule.current_x.size(); ++k) {
    Vector current = Vector::Zero(), rate = Vector::Zero();
    schedule.current_x[k].at(time, side, current.x(), rate.x());
    schedule.current_y[k].at(time, side, current.y(), rate.y());
    out.current.push_back(current);
    out.current_rate.push_back(rate);
  }
  return out;
}

}  // namespace codend

#include "lifting_plate.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "../base/immersion.hpp"

namespace codend {
namespace {

// Derivatives by three positions, then by three velocities.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 18, 1>>;
template <class Scalar>
using Triple = Eigen::Matrix<Scalar, 3, 1>;

double value_of(double x) { return x; }
double value_of(const Dual& x) { return x.value(); }

// Returns a function of x, given its value and derivative at x.
double follow(double, double value, double) { return value; }
Dual follow(const Dual& x, double value, double slope) {
  return Dual(value, slope * x.derivatives());
}

template <class Scalar>
Triple<double> values(const Triple<Scalar>& x) {
  return {value_of(x.x()), value_of(x.y()), value_of(x.z())};
}

template <class Scalar>
Scalar square_root(const Scalar& x) {
  const double root = std::sqrt(value_of(x));
  return follow(x, root, root > 0.0 ? 0.5 / root : 0.0);
}

template <class Scalar>
Scalar angle(const Scalar& y, const Scalar& x) {
  const double a = value_of(y), b = value_of(x), square = a * a + b * b;
  if (square == 0.0) return Scalar(0.0);
  Scalar out = (b / square) * y - (a / square) * x;  // has the derivative of the angle
  return follow(out, std::atan2(a, b), 1.0);
}

template <class Scalar>
Triple<Scalar> cross(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return Triple<Scalar>(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                        a.x() * b.y() - a.y() * b.x());
}

template <class Scalar>
Scalar dot(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

}  // namespace

PressureCentre joessel_pressure_centre(double attack) {
  constexpr double rounding = 0.01;
  const double s = std::sin(attack), c = std::cos(attack);
  const double size = std::sqrt(s * s + rounding * rounding);
  // At 90 deg the other edge meets the flow; both formulas give half of the chord there.
  const double most = std::sqrt(1.0 + rounding * rounding);
  const double way = c < 0.0 ? -1.0 : 1.0;
  return {0.5 - 0.3 * way * (most - size), 0.3 * way * s * c / size};
}

// Positions and velocities of the three points.
template <class Scalar>
struct LiftingPlates::Motion {
  Triple<Scalar> x[3], v[3];
  Triple<Scalar> e1, e2, e3, e1_dot, e2_dot, e3_dot;

  void complete() {
    e1 = x[1] - x[0];
    e2 = x[2] - x[0];
    e3 = cross(e1, e2);
    e1_dot = v[1] - v[0];
    e2_dot = v[2] - v[0];
    e3_dot = cross(e1_dot, e2) + cross(e1, e2_dot);
  }
  Triple<Scalar> vector(const Parts& p) const { return p.a * e1 + p.b * e2 + p.c * e3; }
  Triple<Scalar> place(const Parts& p) const { return x[0] + vector(p); }
  template <class Share>
  Triple<Scalar> velocity(const PartsOf<Share>& p) const {
    return v[0] + p.a * e1_dot + p.b * e2_dot + p.c * e3_dot;
  }
  // Time derivative of a vector of the plate.
  Triple<Scalar> rate(const Parts& p) const { return p.a * e1_dot + p.b * e2_dot + p.c * e3_dot; }
  // Adds the forces of a load on the time derivative of such a vector: a couple on a rigid body.
  void hand_on_rate(const Parts& p, const Triple<Scalar>& load, Triple<Scalar> force[3]) const {
    hand_on(p, load, force);
    force[0] -= load;
  }
  template <class Share>
  void hand_on(const PartsOf<Share>& p, const Triple<Scalar>& load, Triple<Scalar> force[3]) const {
    const Triple<Scalar> f1 = p.a * load + p.c * cross(e2, load);
    const Triple<Scalar> f2 = p.b * load + p.c * cross(load, e1);
    force[0] += load - f1 - f2;
    force[1] += f1;
    force[2] += f2;
  }
};

void LiftingPlates::prepare() {
  fixed_.clear();
  node_.clear();
  for (const LiftingPlate& b : plate) {
    Matrix frame;
    frame.col(0) = b.attachment[1] - b.attachment[0];
    frame.col(1) = b.attachment[2] - b.attachment[0];
    frame.col(2) = frame.col(0).cross(frame.col(1));
    const Matrix inverse = frame.inverse();
    auto direction = [&](const Vector& of) {
      const Vector p = inverse * of;
      return Parts{p.x(), p.y(), p.z()};
    };
    auto place = [&](const Vector& at) { return direction(at - b.attachment[0]); };
    node_.insert(node_.end(), b.node.begin(), b.node.end());
    Fixed f;
    f.leading = place(Vector::Zero());
    f.chord = direction(Vector::UnitX());
    f.span = direction(Vector::UnitZ());
    f.outward = direction(b.side * Vector::UnitY());
    f.gravity = place(b.gravity_centre);
    f.buoyancy = place(b.buoyancy_centre);
    f.middle = place({b.pressure_centre * b.chord, 0.0, 0.0});
    f.centre = place({0.5 * b.chord, 0.0, 0.0});
    for (int k = 0; k < 4; ++k) {
      f.added[k] = place({0.5 * b.chord + (k % 2 ? 1.0 : -1.0) * b.added_radius_chord, 0.0,
                          (k / 2 ? 1.0 : -1.0) * b.added_radius_span});
    }
    Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
    moments(0, 0) = b.mass;
    auto numbers = [](const Parts& p) { return Vector(p.a, p.b, p.c); };
    const Vector gravity = numbers(f.gravity);
    moments.bottomRightCorner<3, 3>() =
        b.mass * gravity * gravity.transpose() +
        inverse * b.second_moment.asDiagonal() * inverse.transpose();
    moments.bottomLeftCorner<3, 1>() = b.mass * gravity;
    moments.topRightCorner<1, 3>() = b.mass * gravity.transpose();
    f.moments = moments;
    f.shoe[0] = place({0.0, 0.0, -0.5 * b.span});
    f.shoe[1] = place({b.chord, 0.0, -0.5 * b.span});
    fixed_.push_back(f);
  }
}

template <class Scalar>
void LiftingPlates::hand_on_inertia(const Fixed& f, const Motion<Scalar>& motion,
                                    const Triple<Scalar>& bending, Triple<Scalar> force[3]) {
  // The last column of Q accelerates by `bending`; J distributes the inertia over all columns.
  const auto row = f.moments.row(3);
  const Triple<Scalar> by_c = Scalar(row[3]) * bending;
  const Triple<Scalar> f1 = row[1] * bending + cross(motion.e2, by_c);
  const Triple<Scalar> f2 = row[2] * bending + cross(by_c, motion.e1);
  force[0] -= row[0] * bending - f1 - f2;
  force[1] -= f1;
  force[2] -= f2;
}

template <class Scalar>
void LiftingPlates::add_forces(int number, const Field& field, const Motion<Scalar>& motion,
                               Triple<Scalar> force[3], PlateAttitude* attitude) const {
  const LiftingPlate& b = plate[static_cast<std::size_t>(number)];
  const Fixed& f = fixed_[static_cast<std::size_t>(number)];
  const Water& water = *field.water;

  const Triple<Scalar> middle = motion.place(f.middle);
  Immersion wet{1.0, 0.0, 1.0, 0.0};
  const Vector here = values(middle);
  WavePoint sea;
  if (field.waves) sea = water.waves.at(here);
  if (water.free_surface) wet = immersion(here.z() - sea.elevation, b.height);
  const Scalar share = follow(middle.z(), wet.share, wet.slope);

  const Scalar none(0.0);
  motion.hand_on(f.gravity, Triple<Scalar>(none, none, Scalar(-b.weight)), force);
  Triple<Scalar> lifted(none, none, b.buoyancy * share);
  if (water.accelerates()) {
    const Vector pushed = b.buoyancy / gravity * (water.acceleration(here.z()) + sea.acceleration);
    for (int k = 0; k < 3; ++k) lifted[k] += pushed[k] * share;
  }
  motion.hand_on(f.buoyancy, lifted, force);

  const Triple<Scalar> chord = motion.vector(f.chord), span = motion.vector(f.span),
                       outward = motion.vector(f.outward);
  Vector current, slope;
  water.velocity(here.z(), current, slope);
  current += sea.velocity;
  slope += sea.velocity_slope;
  if (water.accelerates()) {
    const Vector speeding = water.acceleration(here.z()) + sea.acceleration;
    const Scalar across =
        outward[0] * speeding[0] + outward[1] * speeding[1] + outward[2] * speeding[2];
    const Scalar push = water.density * b.added_mass * share * across;
    motion.hand_on(f.centre, push * outward, force);
  }
  // Accelerations due to velocities alone.
  const Triple<Scalar> bending = 2.0 * cross(motion.e1_dot, motion.e2_dot);
  hand_on_inertia(f, motion, bending, force);

  // Sets u, the velocity of the water relative to a point of the plate, and its components in the
  // plate's axes. moving: velocity of the point.
  Triple<Scalar> u;
  Scalar along_chord, along_outward, along_span;
  auto meet = [&](const Triple<Scalar>& moving) {
    for (int k = 0; k < 3; ++k) u[k] = follow(middle.z(), current[k], slope[k]) - moving[k];
    along_chord = dot(u, chord);
    along_outward = dot(u, outward);
    along_span = dot(u, span);
  };
  meet(motion.velocity(f.centre));
  const Triple<Scalar> past_centre = u;
  // Position of the centre of pressure along the chord, from mid-chord.
  Scalar aft((b.pressure_centre - 0.5) * b.chord);
  if (b.pressure_wanders) {
    const Scalar first = angle(along_outward, along_chord);
    const PressureCentre centre = joessel_pressure_centre(value_of(first));
    aft = b.chord * (follow(first, centre.share, centre.slope) - 0.5);
  }
  auto along_the_chord = [&](const Scalar& way) {
    return PartsOf<Scalar>{f.centre.a + way * f.chord.a, f.centre.b + way * f.chord.b,
                           f.centre.c + way * f.chord.c};
  };
  const PartsOf<Scalar> pressed = along_the_chord(aft);
  meet(motion.velocity(along_the_chord(-aft)));
  const Scalar across2 = along_chord * along_chord + along_outward * along_outward;
  const Scalar across = square_root(across2);
  const Scalar speed = square_root(Scalar(dot(u, u)));
  const Scalar attack = angle(along_outward, along_chord);
  const PolarPoint polar = b.polar.at_angle(value_of(attack));
  const double at_zero = b.polar.at_angle(0.0).drag;
  const Scalar lift_coefficient = follow(attack, polar.lift, polar.lift_slope);
  const Scalar drag_coefficient = follow(attack, polar.drag, polar.drag_slope);
  const Scalar push = 0.5 * water.density * b.area * share;
  // z x U points to starboard of a flow along x.
  const Triple<Scalar> aside = cross(span, u);
  const Scalar lift_factor = b.side * push * lift_coefficient * across;
  const Triple<Scalar> lift = lift_factor * aside;
  Triple<Scalar> load = lift;
  double drag_size = 0.0;
  if (value_of(speed) > 0.0) {
    const Scalar drag_factor =
        push * (drag_coefficient * across2 + at_zero * along_span * along_span) / speed;
    load += drag_factor * u;
    drag_size = value_of(drag_factor) * value_of(speed);
  }
  motion.hand_on(pressed, load, force);

  // Damping moments, and added mass due to turning.
  const Scalar damping = 0.5 * water.density * b.area * share * speed;
  const Scalar yaw_rate = dot(outward, motion.rate(f.chord));
  const Scalar roll_rate = dot(outward, motion.rate(f.span));
  const Scalar yaw = damping * (b.chord * b.chord * b.yaw_damping + b.normal_slope * aft * aft);
  const Scalar roll = damping * (b.span * b.span * b.roll_damping);
  const Triple<Scalar> against_yaw = Scalar(-yaw * yaw_rate) * outward;
  const Triple<Scalar> against_roll = Scalar(-roll * roll_rate) * outward;
  motion.hand_on_rate(f.chord, against_yaw, force);
  motion.hand_on_rate(f.span, against_roll, force);
  const double added = water.density * b.added_mass;
  const Scalar quickening =
      f.centre.c * dot(outward, bending) - dot(motion.rate(f.outward), past_centre);
  const Triple<Scalar> held_back = Scalar(-added * quickening) * outward;
  motion.hand_on(f.centre, held_back, force);

  Vector on_ground = Vector::Zero();
  if (field.ground && field.ground->present) {
    const Ground& ground = *field.ground;
    Rubbing rub = ground.rubbing();
    if (b.own_friction) rub = {b.friction_along, b.friction_across, values(chord)};
    for (std::size_t k = 0; k < 2; ++k) {
      const Parts& shoe = f.shoe[k];
      const Vector* stuck =
          anchor.empty() ? nullptr : &anchor[2 * static_cast<std::size_t>(number) + k];
      const Triple<Scalar> x = motion.place(shoe), v = motion.velocity(shoe);
      Vector contact;
      Matrix by_position, by_velocity;
      ground.contact(values(x), values(v), b.shoe_area, rub, stuck, contact, by_position,
                     by_velocity);
      on_ground += contact;
      Triple<Scalar> carried;
      const Vector x0 = values(x), v0 = values(v);
      for (int i = 0; i < 3; ++i) {
        carried[i] = Scalar(contact[i]);
        for (int l = 0; l < 3; ++l) {
          carried[i] += by_position(i, l) * (x[l] - x0[l]) + by_velocity(i, l) * (v[l] - v0[l]);
        }
      }
      motion.hand_on(shoe, carried, force);
    }
  }

  if (!attitude) return;
  const Vector c = values(chord), s = values(span);
  attitude->attack = value_of(attack);
  attitude->trim = std::atan2(-c.z(), std::hypot(c.x(), c.y()));
  if (b.level) {
    attitude->heel = std::atan2(-s.z(), b.side * values(outward).z());
  } else {
    // Horizontal outward direction, normal to the chord.
    const Vector aside = b.side * Vector::UnitZ().cross(c);
    const double size = aside.norm();
    attitude->heel = std::atan2(size > 0.0 ? s.dot(aside) / size : 0.0, s.z());
  }
  attitude->lift = values(lift).norm();
  attitude->drag = drag_size;
  attitude->force = values(load);
  attitude->ground_force = on_ground;
  attitude->lost_buoyancy = {0.0, 0.0, b.buoyancy * (wet.share - 1.0)};
}

LiftingPlates::Motion<double> LiftingPlates::motion_of(int number, const Field& field) const {
  Motion<double> motion;
  for (int k = 0; k < 3; ++k) {
    const int node = node_[static_cast<std::size_t>(3 * number + k)];
    motion.x[k] = at(field.position, node);
    motion.v[k] = at(field.velocity, node);
  }
  motion.complete();
  return motion;
}

std::vector<Vector> LiftingPlates::shoes(const Field& field) const {
  std::vector<Vector> out;
  for (int e = 0; e < count(); ++e) {
    const Motion<double> motion = motion_of(e, field);
    for (const Parts& shoe : fixed_[static_cast<std::size_t>(e)].shoe) {
      out.push_back(motion.place(shoe));
    }
  }
  return out;
}

void LiftingPlates::draw_anchors(const Field& field) {
  const Ground& ground = *field.ground;
  for (int e = 0; e < count(); ++e) {
    const Motion<double> motion = motion_of(e, field);
    for (std::size_t k = 0; k < 2; ++k) {
      const Parts& shoe = fixed_[static_cast<std::size_t>(e)].shoe[k];
      const Vector x = motion.place(shoe);
      Vector& stuck = anchor[2 * static_cast<std::size_t>(e) + k];
      stuck = ground.draw(stuck, x, motion.velocity(shoe), ground.penetration(x, 0.0) > 0.0);
    }
  }
}

void LiftingPlates::add_force(const Field& field, double* force) const {
  for (int e = 0; e < count(); ++e) {
    Vector f[3] = {Vector::Zero(), Vector::Zero(), Vector::Zero()};
    add_forces<double>(e, field, motion_of(e, field), f, nullptr);
    for (int k = 0; k < 3; ++k) at(force, node_[static_cast<std::size_t>(3 * e + k)]) += f[k];
  }
}

PlateAttitude LiftingPlates::attitude(int e, const Field& field) const {
  Vector f[3] = {Vector::Zero(), Vector::Zero(), Vector::Zero()};
  PlateAttitude out;
  add_forces<double>(e, field, motion_of(e, field), f, &out);
  return out;
}

void LiftingPlates::add_jacobian(const Field& field, const JacobianRequest& request,
                                 const BlockSink& sink) const {
  for (int e = 0; e < count(); ++e) {
    Motion<Dual> motion;
    Triple<Dual> f[3];
    for (int k = 0; k < 3; ++k) {
      for (int c = 0; c < 3; ++c) {
        const std::ptrdiff_t place =
            3 * static_cast<std::ptrdiff_t>(node_[static_cast<std::size_t>(3 * e + k)]) + c;
        motion.x[k][c] = Dual(field.position[place], 18, 3 * k + c);
        motion.v[k][c] = Dual(field.velocity[place], 18, 9 + 3 * k + c);
        f[k][c] = Dual(0.0);
      }
    }
    motion.complete();
    add_forces<Dual>(e, field, motion, f, nullptr);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        Matrix block;
        for (int r = 0; r < 3; ++r) {
          for (int c = 0; c < 3; ++c) {
            const auto& d = f[i][r].derivatives();
            block(r, c) = -request.stiffness * d[3 * j + c] - request.damping * d[9 + 3 * j + c];
          }
        }
        sink.add(e, i, j, block);
      }
    }
  }
}

LiftingPlates::BodyMass LiftingPlates::body_mass(std::size_t number, const Field& field) const {
  const Fixed& f = fixed_[number];
  Motion<double> motion;
  for (std::size_t k = 0; k < 3; ++k) {
    motion.x[k] = at(field.position, node_[3 * number + k]);
    motion.v[k].setZero();
  }
  motion.complete();
  // Derivatives of the columns of Q by the positions of the points.
  using Columns = Eigen::Matrix<double, 3, 9>;
  auto crossing = [](const Vector& a) {
    Matrix m;
    m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
    return m;
  };
  const Matrix one = Matrix::Identity(), none = Matrix::Zero();
  const Matrix by_first = -crossing(motion.e2), by_second = crossing(motion.e1);
  std::array<Columns, 4> change;
  change[0] << one, none, none;
  change[1] << -one, one, none;
  change[2] << -one, none, one;
  change[3] << -by_first - by_second, by_first, by_second;
  BodyMass mass = BodyMass::Zero();
  for (int j = 0; j < 4; ++j) {
    Columns momentum = Columns::Zero();
    for (int k = 0; k < 4; ++k) momentum += f.moments(j, k) * change[static_cast<std::size_t>(k)];
    mass += change[static_cast<std::size_t>(j)].transpose() * momentum;
  }
  const Vector outward = motion.vector(f.outward), middle = motion.place(f.middle);
  double wet = 1.0;
  if (field.water->free_surface) {
    const double surface = field.waves ? field.water->waves.at(middle).elevation : 0.0;
    wet = immersion(middle.z() - surface, plate[number].height).share;
  }
  const double added = 0.25 * wet * field.water->density * plate[number].added_mass;
  for (const Parts& p : f.added) {
    const Eigen::Matrix<double, 1, 9> across =
        outward.transpose() * (change[0] + p.a * change[1] + p.b * change[2] + p.c * change[3]);
    mass += added * across.transpose() * across;
  }
  return mass;
}

double LiftingPlates::heaviest_body(const Field& field) const {
  double most = 0.0;
  for (const LiftingPlate& one : plate) {
    most = std::max(most, one.mass + field.water->density * one.added_mass);
  }
  return most;
}

void LiftingPlates::add_body_mass(const Field& field, double factor, const BlockSink& sink) const {
  for (int e = 0; e < count(); ++e) {
    const BodyMass mass = factor * body_mass(static_cast<std::size_t>(e), field);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) sink.add(e, i, j, mass.block<3, 3>(3 * i, 3 * j));
    }
  }
}

void LiftingPlates::add_body_inertia(const Field& field, const double* acceleration,
                                     double* force) const {
  for (std::size_t e = 0; e < plate.size(); ++e) {
    Eigen::Matrix<double, 9, 1> a;
    for (std::size_t k = 0; k < 3; ++k) {
      a.segment<3>(static_cast<Eigen::Index>(3 * k)) = at(acceleration, node_[3 * e + k]);
    }
    const Eigen::Matrix<double, 9, 1> inertia = body_mass(e, field) * a;
    for (std::size_t k = 0; k < 3; ++k) {
      at(force, node_[3 * e + k]) += inertia.segment<3>(static_cast<Eigen::Index>(3 * k));
    }
  }
}

double LiftingPlates::turn(const double* dx) const {
  double largest = 0.0;
  for (const LiftingPlate& plate : plate) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const Vector change = at(dx, plate.node[next]) - at(dx, plate.node[k]);
      const Vector side = plate.attachment[next] - plate.attachment[k];
      largest = std::max(largest, change.norm() / side.norm());
    }
  }
  return largest;
}

double LiftingPlates::unstable_size(const Field&) const {
  double least = plate.empty() ? 0.0 : plate.front().chord;
  for (const LiftingPlate& one : plate) least = std::min(least, one.chord);
  return least;
}

void LiftingPlates::add_drag_scale(const Field& field, double time, double* scale) const {
  for (int e = 0; e < count(); ++e) {
    Vector u, slope;
    field.relative_velocity(node_[static_cast<std::size_t>(3 * e)],
                            plate[static_cast<std::size_t>(e)].height, u, slope);
    const LiftingPlate& b = plate[static_cast<std::size_t>(e)];
    const double drag = 0.5 * field.water->density * b.area * u.norm() / 3.0;
    // Distributes the mass so that its centroid is the centre of gravity, with positive fractions.
    const Parts& gravity = fixed_[static_cast<std::size_t>(e)].gravity;
    const double part[3] = {std::max(1.0 - gravity.a - gravity.b, 0.1), std::max(gravity.a, 0.1),
                            std::max(gravity.b, 0.1)};
    const double all = part[0] + part[1] + part[2];
    for (int k = 0; k < 3; ++k) {
      scale[node_[static_cast<std::size_t>(3 * e + k)]] += drag + b.mass * part[k] / (all * time);
    }
  }
}

}  // namespace codend

#include "gear.hpp"

namespace codend {

void Gear::check() const {
  const auto fits = [](const char* name, int count, std::size_t given) {
    if (static_cast<std::size_t>(count) != given) {
      throw InputError(name, std::string(name) + " is " + std::to_string(count) + ", but " +
                                 std::to_string(given) + " are given");
    }
  };
  fits("point_count", point_count, points.size());
  fits("rope_count", rope_count, ropes.size());
  fits("panel_count", panel_count, panels.size());
  fits("share_count", share_count, share_places.size());
}

}  // namespace codend

// Kinds of measures and their natures, made by `make schema` from
// inst/schema/measures.csv, which defines each: do not edit by hand.
#pragma once

// clang-format off
#include <array>
#include <cstddef>

namespace codend {

enum class MeasureKind { spread, height, length, depth, sinking_speed, clearance, area, enclosed_area, ground_speed, angle, attitude, tension, drag, lift, mesh_opening, mesh_angle, volume, volume_share, enclosed_volume, total_drag, tow_power, filtered_volume, swept_area, mouth_blockage, engine_power, pull_used, fuel_rate, fuel_per_swept_area, fuel_per_filtered_volume, fuel_per_catch, catch_volume, catch_surface, catch_front, largest_rope_tension, largest_panel_twine_tension, most_loaded_twine_tension, slack_netting, rope_on_ground, ground_load, ground_friction, least_depth, greatest_depth };
constexpr std::array<const char*, 42> names_of(MeasureKind) {
  return {"spread", "height", "length", "depth", "sinking_speed", "clearance", "area", "enclosed_area", "ground_speed", "angle", "attitude", "tension", "drag", "lift", "mesh_opening", "mesh_angle", "volume", "volume_share", "enclosed_volume", "total_drag", "tow_power", "filtered_volume", "swept_area", "mouth_blockage", "engine_power", "pull_used", "fuel_rate", "fuel_per_swept_area", "fuel_per_filtered_volume", "fuel_per_catch", "catch_volume", "catch_surface", "catch_front", "largest_rope_tension", "largest_panel_twine_tension", "most_loaded_twine_tension", "slack_netting", "rope_on_ground", "ground_load", "ground_friction", "least_depth", "greatest_depth"};
}

// Classes of measures whose relative errors are alike, and what they are numbers of.
enum class MeasureClass { opening, place, force, netting };
enum class MeasureQuantity { length, other, area, force, volume, power, twine_force };
struct MeasureNature {
  MeasureClass of;
  MeasureQuantity in;
};

inline MeasureNature nature_of(MeasureKind kind) {
  constexpr MeasureNature natures[] = {
      {MeasureClass::opening, MeasureQuantity::length},  // spread
      {MeasureClass::opening, MeasureQuantity::length},  // height
      {MeasureClass::place, MeasureQuantity::length},  // length
      {MeasureClass::place, MeasureQuantity::length},  // depth
      {MeasureClass::opening, MeasureQuantity::other},  // sinking_speed
      {MeasureClass::opening, MeasureQuantity::length},  // clearance
      {MeasureClass::opening, MeasureQuantity::area},  // area
      {MeasureClass::opening, MeasureQuantity::area},  // enclosed_area
      {MeasureClass::opening, MeasureQuantity::other},  // ground_speed
      {MeasureClass::opening, MeasureQuantity::other},  // angle
      {MeasureClass::opening, MeasureQuantity::other},  // attitude
      {MeasureClass::force, MeasureQuantity::force},  // tension
      {MeasureClass::force, MeasureQuantity::force},  // drag
      {MeasureClass::force, MeasureQuantity::force},  // lift
      {MeasureClass::opening, MeasureQuantity::other},  // mesh_opening
      {MeasureClass::opening, MeasureQuantity::other},  // mesh_angle
      {MeasureClass::opening, MeasureQuantity::volume},  // volume
      {MeasureClass::opening, MeasureQuantity::other},  // volume_share
      {MeasureClass::opening, MeasureQuantity::volume},  // enclosed_volume
      {MeasureClass::force, MeasureQuantity::force},  // total_drag
      {MeasureClass::force, MeasureQuantity::power},  // tow_power
      {MeasureClass::opening, MeasureQuantity::other},  // filtered_volume
      {MeasureClass::opening, MeasureQuantity::other},  // swept_area
      {MeasureClass::opening, MeasureQuantity::other},  // mouth_blockage
      {MeasureClass::force, MeasureQuantity::power},  // engine_power
      {MeasureClass::force, MeasureQuantity::other},  // pull_used
      {MeasureClass::force, MeasureQuantity::other},  // fuel_rate
      {MeasureClass::opening, MeasureQuantity::other},  // fuel_per_swept_area
      {MeasureClass::opening, MeasureQuantity::other},  // fuel_per_filtered_volume
      {MeasureClass::opening, MeasureQuantity::other},  // fuel_per_catch
      {MeasureClass::opening, MeasureQuantity::volume},  // catch_volume
      {MeasureClass::opening, MeasureQuantity::area},  // catch_surface
      {MeasureClass::opening, MeasureQuantity::other},  // catch_front
      {MeasureClass::force, MeasureQuantity::force},  // largest_rope_tension
      {MeasureClass::netting, MeasureQuantity::twine_force},  // largest_panel_twine_tension
      {MeasureClass::netting, MeasureQuantity::twine_force},  // most_loaded_twine_tension
      {MeasureClass::netting, MeasureQuantity::other},  // slack_netting
      {MeasureClass::netting, MeasureQuantity::length},  // rope_on_ground
      {MeasureClass::force, MeasureQuantity::force},  // ground_load
      {MeasureClass::force, MeasureQuantity::other},  // ground_friction
      {MeasureClass::place, MeasureQuantity::length},  // least_depth
      {MeasureClass::place, MeasureQuantity::length},  // greatest_depth
  };
  return natures[static_cast<std::size_t>(kind)];
}

}  // namespace codend

// Ropes, pieces and plates as elements of a lattice, and the supports and loads of its nodes.
#pragma once

#include <vector>

#include "../elements/bending.hpp"
#include "../elements/ground_contact.hpp"
#include "../elements/immersed_volume.hpp"
#include "collection.hpp"
#include "division.hpp"

namespace codend {

void add_ropes(Collection& to, const Gear& gear, const Division& division);
void add_pieces(Collection& to, const Gear& gear, const Division& division);
// Struts between the points of every plate.
void add_plates(Collection& to, const Gear& gear, const Division& division);

// The nodes that a piece is spread over, or null where it sits at a place.
const NodeRun* piece_run(const Gear& gear, const Division& division, int piece);

// Which nodes are held and where (m), and the loads of points (N), 3 each.
struct Supports {
  std::vector<char> held;
  std::vector<double> position, load;
};
Supports gear_supports(const Gear& gear, const Division& division);

// Adds to loads (N, 3 per point) what ropes weigh in water more than by their masses.
void add_weights(const Gear& gear, const Division& division, std::vector<double>& load);

// Of ropes that resist bending, between every two of their bars.
Bends rope_bends(const Gear& gear, const Division& division);
// Ropes that rub differently along and across themselves; a node of two is the first's.
LineFriction line_friction(const Gear& gear, const Division& division);

// Per point that has an area on the ground, that and half of the greatest height there.
GroundContacts ground_contacts(const std::vector<Mass>& masses, int points);
// Volumes that leave the water over one height at one point, together.
ImmersedVolumes immersed_volumes(const std::vector<Mass>& masses, int points, double density);

}  // namespace codend

// Elements of ropes, pieces and plates; supports and loads of nodes.
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
// Adds struts between the points of every plate.
void add_plates(Collection& to, const Gear& gear, const Division& division);

// Nodes over which a piece is distributed; null if it is at one location.
const NodeRun* piece_run(const Gear& gear, const Division& division, int piece);

// Fixed nodes and their positions (m), and loads of all points (N), 3 each.
struct Supports {
  std::vector<char> held;
  std::vector<double> position, load;
};
Supports gear_supports(const Gear& gear, const Division& division);

// Adds to loads (N, 3 per point) the change of the ropes' weight in water by `weight_factor`.
void add_weights(const Gear& gear, const Division& division, std::vector<double>& load);

// Bends between consecutive bars of ropes with bending stiffness.
Bends rope_bends(const Gear& gear, const Division& division);
// Anisotropic friction of ropes. A node of two ropes takes the friction of the first.
LineFriction line_friction(const Gear& gear, const Division& division);

// Sums contact areas per point; the clearance is half of the largest height there.
GroundContacts ground_contacts(const std::vector<Mass>& masses, int points);
// Volumes at one point with equal height at the free surface are combined.
ImmersedVolumes immersed_volumes(const std::vector<Mass>& masses, int points, double density);

}  // namespace codend

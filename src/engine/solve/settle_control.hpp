// What settling is held to, and the numbers that steer it on its way.
//
// The latter change how fast and how surely a shape is found; of the shape itself only what the
// tolerances leave open.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "../model/wake.hpp"

namespace codend {

struct SettleProgress {
  int iteration;
  double residual;  // largest nodal force over largest tension
};

// Where x begins: anywhere; near the result, as carried over from another lattice; or at what was
// settled for the same lattice with other numbers. A settled start takes Newton steps that carry the
// tensions it was settled with, undamped; where they do not close in it is given up, x as it was.
enum class Start { crude, near, settled };
constexpr std::array<const char*, 3> names_of(Start) { return {"crude", "near", "settled"}; }

// Of the damping D/h (pseudo_time.hpp). Rotation is the largest change of any line's vector in one
// step, over its rest length. A linear step says nothing of where a line goes that turns by more than its
// own length, or of a body that leaves the water or comes into it, whose buoyancy it misses by so large a
// share: of a step only as much is taken as turns lines by what is aimed at, 1 at first, and h goes by that
// over the step's rotation.
struct PseudoTimeControl {
  // A plate's forces are other ones after some degrees, of which a linear step knows nothing: its turn
  // counts for so many times that of a line, where it does not close in from a settled state. With 12
  // some kites of 300 still go to a balance far from where they start, with 20 none.
  double plate_turns = 20.0;
  // Below this the shape counts as found: a rotation t changes strains by t^2/2, which the step
  // leaves out, here 2e-4 at most.
  double found_rotation = 0.02;
  // s: steps are then next to undamped; those from a settled shape begin with it.
  double longest = 1e6;
  // Most starts are through in so many steps. Later ones, until the shape is found, are judged by the step
  // that would correct them: where that is larger, or the matrix is singular, the next turns lines by
  // less, `shorter` times what this one did, else by more, up to a whole turn.
  int free_steps = 10;
  double shorter = 0.7;
};

// Netting along the flow has next to no pull, so that steps would turn it far beyond what their matrix
// knows. There every line counts as tauter by this share of its drag across the flow, wholly where the last
// step turned lines by `rotation`, less where by less: that holds them against turns, not against going on
// together.
struct HeldControl {
  double share = 0.3, rotation = 0.2;
};

// Of the interior path (tension_path.hpp). Tensions far down the path belong to the present shape: in a
// step its parameter mu falls by the factor by which the last one turned lines.
struct PathControl {
  double least_factor = 0.02;
  // mu is no less than this times the square of the last rotation, to which it rises by so much a step
  // at most: where lines still turn, tensions far down the path are of no shape.
  double least_by_turn = 1e-8, most_rise = 10.0;
  // Where the shape is found, a step leaves most of all the product of its changes of tensions and of
  // slack: the same factors take that away (the corrector of Mehrotra 1992, On the implementation of a
  // primal-dual interior point method, SIAM J. Optim. 2, 575-601), where that is less than this share of
  // the step.
  double most_correction = 0.5;
  // From a settled state's tensions mu falls at once to this share, where the shape is found.
  double settled_factor = 1e-3;
};

// Of trials of the constitutive law itself. A trial fails where the shape is no longer found, or where
// `steps` have not brought the residual below `closing` of its own first; the path then goes on from where
// it was left, for as many steps before the next trial, doubled by every one that fails: trials stay a
// small part of all steps where they cannot succeed yet.
struct LawControl {
  double residual = 1e-4;  // of the path's shape, below which it is tried
  // Below this residual a start counts as near.
  double near_residual = 0.1;
  int steps = 3;
  double closing = 0.3;
};

// Of the linear equations of a step.
struct LinearControl {
  // Steps are solved to this residual over the right side; Newton's method gains nothing from more. Where
  // one is above `limit` factors are in double precision from then on.
  double tolerance = 1e-4, limit = 0.1;
};

// Of steps from a settled shape under other loads, which have failed after so many, or where one after the
// first turns lines by more than `rotation`.
struct SettledControl {
  int steps = 30;
  double rotation = 1.0;
};

// Of wakes. They are renewed on every settled shape until no point's share of the free flow's speed
// changes by more than `tolerance`. The netting upstream of points is looked for near balance once: on
// the border of a wake points would come and go for ever, each time for as many steps as a start takes.
struct WakeControl {
  double tolerance = wake_tolerance;
  int renewals = 20;
  // From other than a settled state they are followed before: where the shape is found and the residual
  // below `residual` of the law; of a shape that is carried over below its near_residual, and from the
  // start on as long as the path's mu is at least this, looking for netting upstream each time.
  double far_parameter = 1e-6;
};

// Of unstable equilibria (stability.hpp): a perturbation of this share of the least unstable element's
// size, small beside it and large beside what Newton's method would take back at once; h stays below
// `pace` of the time in which the motion grows, so that steps follow it, for so many steps.
struct PerturbationControl {
  double size = 0.1, pace = 0.4;
  int steps = 40;
  int most = 4;  // perturbations, to and fro
};

struct SettleControl {
  double tolerance = 1e-8;  // on the residual; where rounding alone makes more, that is enough
  int iterations = 500;     // at most
  Start start = Start::crude;
  // Strains of all lines in a like state that the tensions begin from, where x is near or settled;
  // empty: those of x itself.
  std::vector<double> strain;
  // What part every line is of (part_balance.hpp), each of which is held to part_tolerance of its own
  // forces besides; empty: all are of one.
  std::vector<int> part;
  double part_tolerance = 1e-6;
  bool timed = true;  // whether the report tells CPU seconds
  // Called once an iteration; returns false to stop.
  std::function<bool(const SettleProgress&)> watch;
  // Called a few times in every second that an iteration's linear equations take; what it throws ends
  // the settling.
  std::function<void()> pause;

  // What rounds to a force beside which the loads are little is no balance: the share of all loads
  // together that rounding may leave.
  double greatest_rounding = 1e-3;
  PseudoTimeControl pseudo_time;
  HeldControl held;
  PathControl path;
  LawControl law;
  LinearControl linear;
  SettledControl settled;
  WakeControl wake;
  PerturbationControl perturbation;
};

}  // namespace codend

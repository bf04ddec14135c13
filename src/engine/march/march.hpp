// A motion from one time to another by steps of a scheme: how long they are, and what becomes of
// steps that are not good enough.
//
// With an accuracy, a step whose own error of position is larger is repeated shorter, and the next
// is as long as its error allows. Without one, steps have one length. Where a scheme does not find
// a step it is repeated at half the length, down to the least; then the march ends and says where.
// Steps end exactly at the times that are asked for.
#pragma once

#include <functional>

#include "stepper.hpp"

namespace codend {

struct MarchControl {
  double accuracy = 0.0;     // m, of one step; 0: steps of one length
  double step = 0.1;         // s, the first, or the length of all
  double least_step = 1e-7;  // s
  double most_step = 60.0;   // s
  // Called after every step that is taken; returns false to stop.
  std::function<bool(const Motion& now)> watch;
};

struct MarchReport {
  enum class End { reached, stopped, stuck } end = End::reached;
  long long steps = 0;       // taken
  long long repeated = 0;    // because of their error
  long long not_found = 0;   // because the scheme found none
  long long iterations = 0;
  double shortest_step = 0.0, longest_step = 0.0;  // s, of those taken
  int worst_node = -1;       // where the last step that was not taken failed
};

class March {
 public:
  // All are kept by reference. past: at the start, now alone, or as another march left it together
  // with its step().
  March(Assembly& assembly, Stepper& stepper, Conditions& conditions, const MarchControl& control,
        Past past);

  // Goes on until `time` (s), which must not lie before now.
  MarchReport::End to(double time);
  // The motion breaks here: what was before says nothing of what comes.
  void begin_anew();

  const Motion& now() const { return past_.now; }
  const Past& past() const { return past_; }
  double step() const { return step_; }
  const MarchReport& report() const { return report_; }

 private:
  void limit_step();

  Assembly& assembly_;
  Stepper& stepper_;
  Conditions& conditions_;
  const MarchControl& control_;
  Past past_;
  Motion next_;
  double step_;
  int since_limited_ = 0;
  MarchReport report_;
};

}  // namespace codend

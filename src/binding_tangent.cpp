// Measures of gears near a settled one for R.
#include "binding_list.h"
#include "binding_model.h"
#include "engine/measure/near_gear.hpp"

using namespace binding;

namespace {

// Two lists do not hold the same but for numbers.
struct Unlike {};

// The numbers on the line through those of two lists that are the same otherwise, as a source of the
// engine's fields: share 0 is the first, 1 the second.
class BetweenSource {
 public:
  static constexpr int first_place = ListSource::first_place;

  BetweenSource(const ListSource& first, const ListSource& second, double share)
      : first_(first), second_(second), share_(share) {}

  std::vector<std::string> names() const { return same(first_.names(), second_.names()); }
  std::vector<double> numbers(const char* name) const {
    std::vector<double> out = first_.numbers(name);
    const std::vector<double> other = second_.numbers(name);
    if (other.size() != out.size()) throw Unlike();
    for (std::size_t k = 0; k < out.size(); ++k) {
      if (out[k] != other[k]) out[k] += share_ * (other[k] - out[k]);
    }
    return out;
  }
  std::vector<int> whole_numbers(const char* name) const {
    return same(first_.whole_numbers(name), second_.whole_numbers(name));
  }
  std::vector<std::string> words(const char* name) const {
    return same(first_.words(name), second_.words(name));
  }
  BetweenSource group(const char* name) const {
    return {first_.group(name), second_.group(name), share_};
  }
  std::vector<BetweenSource> items(const char* name) const {
    const std::vector<ListSource> first = first_.items(name), second = second_.items(name);
    if (first.size() != second.size()) throw Unlike();
    std::vector<BetweenSource> out;
    for (std::size_t k = 0; k < first.size(); ++k) out.push_back({first[k], second[k], share_});
    return out;
  }

 private:
  template <class Values>
  static Values same(Values first, const Values& second) {
    if (first != second) throw Unlike();
    return first;
  }

  ListSource first_, second_;
  double share_;
};

}  // namespace

// numbers: of a gear (measure/measured_gear.hpp); counts, position (3 x points) and wake of its settled
// lattice. Returns list(near, measures (SI)), or NULL where nothing near can be found so.
[[cpp11::register]] SEXP engine_near_gear(list numbers, list counts, doubles position,
                                          doubles wake) {
  return guarded([&]() -> SEXP {
    auto near = std::make_unique<codend::NearGear>(
        codend::read_fields<codend::GearNumbers>(ListSource(numbers)),
        codend::read_fields<codend::Counts>(ListSource(counts)), binding::numbers(position),
        binding::numbers(wake));
    if (!near->regular()) return R_NilValue;
    const sexp measures = as_doubles(near->measures());
    return writable::list({
        "near"_nm = external_pointer<codend::NearGear>(near.release()),
        "measures"_nm = measures,
    });
  });
}

// Change of measures (SI, see NearMeasures) to a gear on the line through those of two lists of numbers,
// list(change, factorisations); NULL where the lists differ in more than numbers, no change where steps
// lead to no balance. tolerance, steps, renewals, closes_in, reach: as NearControl.
[[cpp11::register]] SEXP engine_near_change(SEXP near, list first, list second, double share,
                                            double tolerance, int steps, int renewals,
                                            bool closes_in, double reach) {
  return guarded([&]() -> SEXP {
    const external_pointer<codend::NearGear> from(near);
    try {
      const auto numbers = codend::read_fields<codend::GearNumbers>(
          BetweenSource(ListSource(first), ListSource(second), share));
      const codend::NearMeasures found =
          from->measure(numbers, {tolerance, steps, renewals, closes_in, reach});
      return writable::list({
          "change"_nm = as_doubles(found.change),
          "factorisations"_nm = found.factorisations,
      });
    } catch (const Unlike&) {
      return R_NilValue;
    }
  });
}

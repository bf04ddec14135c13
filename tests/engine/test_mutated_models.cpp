// Texts of models: written and read back the same, and damaged ones refused or harmless.
#include <doctest/doctest.h>

#include "mutated_models.hpp"

using namespace codend;

TEST_CASE("a model that is written and read has the same forces") {
  for (std::uint64_t k = 1; k <= 8; ++k) {
    Random random(k);
    const ModelText of(k);
    Model model = read_fields<Model>(TextSource(of.text));
    model.prepare();
    Assembly assembly(model);
    std::vector<double> x = of.x;
    const Evaluation found = evaluate(assembly, x.data(), of.v.data());
    CAPTURE(k);
    CHECK((found.force == of.force) == !of.hexagonal);
    CHECK(try_text(of, of.text));
  }
}

TEST_CASE("a damaged text of a model is refused, or taken without harm") {
  const Tried tried = try_damaged_models(1, 1500);
  // both happen often, or nothing is tried
  CHECK(tried.refused > 500);
  CHECK(tried.taken > 150);
}

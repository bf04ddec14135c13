// Texts of models: writing and reading preserve them, and damaged texts are rejected or harmless.
#include <doctest/doctest.h>

#include "mutated_models.hpp"

using namespace codend;

TEST_CASE("model keeps its forces after writing and reading") {
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

TEST_CASE("damaged model texts are rejected or read without harm") {
  const Tried tried = try_damaged_models(1, 1500);
  // the test is meaningful only if both happen often
  CHECK(tried.refused > 500);
  CHECK(tried.taken > 150);
}

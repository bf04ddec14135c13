# Runs once, when the package is installed. The name makes this the last plan file in loading order.
schema <- read_schema()
schema_descriptions <- attr(schema, "descriptions")
for (kind in names(compiled <- compile_schema(schema))) {
  assign(paste0("plan_kind_", kind), compiled[[kind]])
}
plan_kinds <- names(compiled)
rm(kind, schema, compiled)

# Made once, when the package is installed: this file is read last, and all that it needs is known.
plan_schema <- compile_schema()

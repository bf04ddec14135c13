# Makes net-in-starting-current.csv: time integration of the net of cases/started-net.R. The
# fourth-order Runge-Kutta method with stable steps shares no line with the implicit schemes. It
# takes some CPU minutes.
library(codend)
source("validation/manifest.R")
for (name in c("square-net", "stiff-lines", "started-net")) {
  source(file.path("validation", "cases", paste0(name, ".R")))
}

rows <- lapply(c(8, 20, 40), function(n) {
  found <- tow(started_net(n), scheme = "rk4", nodes = 1e4)
  started_net_rows(n, found)
})
table <- do.call(rbind, rows)
table$value <- signif(table$value, 8)
utils::write.csv(table, "validation/references/net-in-starting-current.csv", row.names = FALSE,
  quote = FALSE)

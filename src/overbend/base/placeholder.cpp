namespace overbend {}

"""The parts of tests/same. Data flows one way: builds and cases, run, scrub, compare, report."""

// For the program that measures what exact stages cost.
#pragma once

namespace sightline::comparison {

/// While true the predicates of plain/predicates.cpp are exact, by integers of any length: until scene and tree are
/// made.
extern bool prepares;

}  // namespace sightline::comparison

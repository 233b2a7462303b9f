// Right maps to damage, and hands to damage them with.
#pragma once

#include "verify/verify.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace sightline::verify {

using Json = nlohmann::json;

std::string data_file(const std::string& name);
Json load_map(const std::string& name);
Report check_map(const std::string& name, const Json& map);
/// The names of the checks that found faults, each followed by a blank.
std::string checks_of(const Report& report);
std::string all_faults(const Report& report);

/// Edges of a map of some kind.
std::vector<std::size_t> edges_of_kind(const Json& map, const std::string& kind);
/// Adds a vertex in the middle of an edge, at st on two lines of the map.
std::size_t split_edge(Json& map, std::size_t edge, double s, double t, std::size_t line);
/// Takes edges out, and the vertices that have no edge then; loops must be made anew.
void remove_edges(Json& map, std::vector<std::size_t> edges);
/// Takes a face out that no edge names any more.
void remove_face(Json& map, std::size_t face);
/// Makes every loop anew from the edges' sides (decided in doubles), the outer one first.
void retrace(Json& map);

}  // namespace sightline::verify

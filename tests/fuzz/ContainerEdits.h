#pragma once
#include <cstddef>
#include <string>
#include <string_view>

/// Containers, one of each kind of entry, that the fuzzers start from.
std::size_t containerCount();
const std::string& containerBytes(std::size_t index);
/// The same in HDF5's first format, whose metadata have no checksums: damage goes through to its readers.
std::string withoutChecksums(const std::string& container);

/// A container with damage that no checksum shows: `recipe` picks one of those above and is then read as orders to
/// delete, replace and link attributes, arrays and groups, carried out through HDF5's own interface.
std::string editedContainer(std::string_view recipe);

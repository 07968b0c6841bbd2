#pragma once
#include <string>
#include <vector>

class vtkImageData;
class vtkTable;

namespace brdf::app {

/// A table and what it is of, for comma-separated files.
struct NamedTable {
  std::string material, kind;
  vtkTable* table;
};

/// All rows of all tables: columns "material" and "kind", then the union of the tables' own; a column that a table
/// lacks is empty there. Numbers read back exactly; "nan" is no value. Replaces `path` when complete.
void writeCsv(const std::vector<NamedTable>& tables, const std::string& path);

/// The cells of a vtkBRDFSlice or vtkBRDFHoleMap: their two coordinates, then their arrays.
void writeCsv(vtkImageData* image, const std::string& path);

/// The values of a vtkBRDFSlice as an EXR picture (32-bit float), the second axis upwards, not a number where there is
/// no value. Throws brdf::Error for other than 1 or 3 channels.
void writeSliceExr(vtkImageData* slice, const std::string& path);

}  // namespace brdf::app

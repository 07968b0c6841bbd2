#include "SliceTables.h"

#include <brdf/base/Error.h>
#include <brdf/base/File.h>
#include <brdf/base/Text.h>
#include <brdf/io/ImageFile.h>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <limits>

namespace brdf::app {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string fieldText(vtkImageData* image, const char* name, vtkIdType index) {
  auto* array = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(name));
  return array && index < array->GetNumberOfValues() ? std::string(array->GetValue(index)) : std::string();
}

constexpr std::array<const char*, 4> kStates{"no value", "measured or computed", "filled or extrapolated",
                                             "below the horizon"};

}  // namespace

void writeCsv(const std::vector<NamedTable>& tables, const std::string& path) {
  std::vector<std::string> columns;
  for (const NamedTable& named : tables)
    for (vtkIdType k = 0; k < named.table->GetNumberOfColumns(); ++k) {
      const std::string name = named.table->GetColumnName(k);
      if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
    }
  std::string text = "material,kind";
  for (const std::string& column : columns) text += "," + quoted(column);
  for (const NamedTable& named : tables)
    for (vtkIdType row = 0; row < named.table->GetNumberOfRows(); ++row) {
      text += "\n" + quoted(named.material) + "," + named.kind;
      for (const std::string& column : columns) {
        auto* array = vtkDataArray::SafeDownCast(named.table->GetColumnByName(column.c_str()));
        text += "," + (array ? formatNumber(array->GetTuple1(row)) : std::string());
      }
    }
  writeFile(path, text + "\n");
}

void writeCsv(vtkImageData* image, const std::string& path) {
  vtkFieldData* fields = image->GetFieldData();
  vtkDataArray *x = fields->GetArray("x"), *y = fields->GetArray("y");
  vtkPointData* data = image->GetPointData();
  std::string text = quoted(fieldText(image, "axes", 0)) + "," + quoted(fieldText(image, "axes", 1));
  for (int k = 0; k < data->GetNumberOfArrays(); ++k) {
    vtkDataArray* array = data->GetArray(k);
    const std::string name = array->GetName();
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      text +=
          "," + quoted(name == "value" && array->GetNumberOfComponents() > 1 ? fieldText(image, "channels", c) : name);
  }
  for (vtkIdType j = 0; j < y->GetNumberOfTuples(); ++j)
    for (vtkIdType i = 0; i < x->GetNumberOfTuples(); ++i) {
      const vtkIdType point = j * x->GetNumberOfTuples() + i;
      text += "\n" + formatNumber(x->GetTuple1(i)) + "," + formatNumber(y->GetTuple1(j));
      vtkDataArray* states = data->GetArray("state");
      const bool missing = states && (states->GetTuple1(point) == 0 || states->GetTuple1(point) == 3);
      for (int k = 0; k < data->GetNumberOfArrays(); ++k) {
        vtkDataArray* array = data->GetArray(k);
        for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
          if (array == states)
            text += std::string(",") + kStates[static_cast<std::size_t>(array->GetComponent(point, c)) % 4];
          else
            text += "," + (missing ? std::string("nan") : formatNumber(array->GetComponent(point, c)));
        }
      }
    }
  writeFile(path, text + "\n");
}

void writeSliceExr(vtkImageData* slice, const std::string& path) {
  vtkDataArray* values = slice->GetPointData()->GetArray("value");
  vtkDataArray* states = slice->GetPointData()->GetArray("state");
  const int channels = values->GetNumberOfComponents();
  if (channels != 1 && channels != 3)
    throw Error(Error::Kind::Value, {"an EXR picture of a slice has 1 or 3 channels", path,
                                     std::to_string(channels) + " channels", "--channel rgb, or one channel"});
  const auto width = static_cast<std::size_t>(slice->GetDimensions()[0]),
             height = static_cast<std::size_t>(slice->GetDimensions()[1]);
  Image image(width, height, static_cast<std::size_t>(channels));
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const auto point = static_cast<vtkIdType>((height - 1 - y) * width + x);
      const double state = states->GetTuple1(point);
      for (int c = 0; c < channels; ++c)
        image.pixel(x, y)[c] = state == 0 || state == 3 ? std::numeric_limits<float>::quiet_NaN()
                                                        : static_cast<float>(values->GetComponent(point, c));
    }
  writeExr(image, path);
}

}  // namespace brdf::app

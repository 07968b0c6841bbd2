#include "Arguments.h"
#include "Assumptions.h"
#include "Colours.h"
#include "Commands.h"
#include "Output.h"
#include "Pictures.h"

#include <brdf/base/Text.h>

#include <nlohmann/json.hpp>

namespace brdf::app {

Command errorCommand() {
  struct Values {
    ErrorPicture request;
    std::string size = "900x700";
  };
  const auto values = std::make_shared<Values>();
  return {
      "error", "Map where two materials differ over the directions",
      "  brdf error \"0.3*Lambertian + 0.05*GGX(alpha=0.25)\" \"0.3*Lambertian + 0.05*GGX(alpha=0.2)\" --out "
      "error.png\n"
      "  brdf error spectral.xml spectral.csv --channel rgb --illuminant F11 --out lamp.png",
      [values](Arguments& arguments) {
        ErrorPicture& request = values->request;
        arguments.positional("A", request.a, "A material");
        arguments.positional("B", request.b, "Another; when measured, its own samples are compared");
        arguments.choice("--measure", request.measure, {"difference", "absolute", "relative", "log", "cuberoot"},
                         "What is averaged in each cell");
        arguments.choice("--axes", request.axes, {"theta_i,theta_o", "theta_h,theta_d"}, "The two angles of the map");
        arguments.option("--channel", request.channel, "NAME",
                         "rgb, luminance, a number from 0, or a wavelength such as 550nm [luminance]");
        declareColours(arguments, request.colours, true);
        arguments.option("--resolution", request.resolution, {0, 1000}, "Cells along each axis; 0 chooses");
        arguments.option("--size", values->size, "WxH", "Pixels of the picture [900x700]");
        arguments.option("--out", request.out, "FILE", "x.png, or x.vti or x.exr for the numbers; several times");
        arguments.required();
      },
      [values](const Output& output) {
        ErrorPicture& request = values->request;
        request.assumptions = assumptions();
        request.size = sizeOption(values->size);
        colourSettings(request.colours);  // says what is wrong before anything is loaded
        checkPictureOutputs(request.out, {".png", ".vti", ".exr"});
        const ErrorResult result = pictures().error(request);
        output.line(joined(request.out) + ": " + result.label + ", mean " + number(result.mean) + ", largest cell " +
                    number(result.largest) + "; " + result.sampling);
        output.report({{"a", request.a},
                       {"b", request.b},
                       {"measure", request.measure},
                       {"label", result.label},
                       {"axes", request.axes},
                       {"colour", coloursJson(request.colours)},
                       {"mean", result.mean},
                       {"largest", result.largest},
                       {"count", result.count},
                       {"sampling", result.sampling},
                       {"out", request.out}});
      }};
}

}  // namespace brdf::app

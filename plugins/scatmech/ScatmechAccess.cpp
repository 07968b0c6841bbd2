#include "ScatmechAccess.h"

#include <brdf.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <exception>
#include <filesystem>
#include <optional>
#include <thread>
#include <utility>

#ifdef __linux__
#include <sched.h>
#include <stdlib.h>
#include <unistd.h>
#endif

namespace scatmech {
namespace {

/// All models of a kind that can be made, by name; a kind may be registered under two parents.
std::vector<const SCATMECH::Inheritance*> makeable(const SCATMECH::Inheritance& kind) {
  std::vector<const SCATMECH::Inheritance*> found;
  for (const SCATMECH::Inheritance* item : kind.get_progeny())
    if (item->is_instantiable()) found.push_back(item);
  std::sort(found.begin(), found.end(), [](auto* a, auto* b) { return a->get_name() < b->get_name(); });
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<std::string> namesOf(const SCATMECH::Inheritance& kind) {
  std::vector<std::string> names;
  for (const SCATMECH::Inheritance* item : makeable(kind)) names.push_back(item->get_name());
  return names;
}

const SCATMECH::Inheritance& brdfModels() {
  static const bool registered = [] {
    SCATMECH::Register(static_cast<const SCATMECH::Model*>(nullptr));
    SCATMECH::Register(static_cast<const SCATMECH::BRDF_Model*>(nullptr));
    SCATMECH::Model::set_quiet(1);
    return true;
  }();
  (void)registered;
  return SCATMECH::BRDF_Model::inheritance;
}

/// The model that a parameter chooses, or null for a parameter that chooses none.
const SCATMECH::Model* innerModel(const SCATMECH::ModelParameterBase& parameter, const SCATMECH::Model& model) {
  if (!parameter.get_inheritance(nullptr)) return nullptr;
  return static_cast<const SCATMECH::Model*>(parameter.get_ptr(&model));
}

/// The parameter called `name` of a model; "psd.A" is A of the model that is its parameter psd.
const SCATMECH::ModelParameterBase& findParameter(const SCATMECH::Model& model, const std::string& name) {
  const std::size_t dot = name.find('.');
  const std::string own = name.substr(0, dot);
  std::vector<std::string> names;
  for (const SCATMECH::ModelParameterBase* parameter : model.get_inheritance().get_parameters()) {
    names.push_back(parameter->name);
    if (parameter->name != own) continue;
    if (dot == std::string::npos) return *parameter;
    const SCATMECH::Model* inner = innerModel(*parameter, model);
    if (!inner) throw Failure("a parameter without parameters of its own", own);
    return findParameter(*inner, name.substr(dot + 1));
  }
  throw Failure("unknown parameter", own, names);
}

std::optional<double> number(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool isComplex(std::string_view text) {
  const std::size_t comma = text.find(',');
  return text.size() >= 5 && text.front() == '(' && text.back() == ')' && comma != std::string_view::npos &&
         number(text.substr(1, comma - 1)) && number(text.substr(comma + 1, text.size() - comma - 2));
}

/// SCATMECH takes text that is no number for 0, and says nothing.
void checkText(const SCATMECH::ModelParameterBase& parameter, const std::string& text) {
  const auto value = number(text);
  std::error_code ignored;
  const bool file = std::filesystem::is_regular_file(text, ignored);
  if (const SCATMECH::Inheritance* kind = parameter.get_inheritance(nullptr)) {
    const auto names = namesOf(*kind);
    if (std::find(names.begin(), names.end(), text) == names.end()) throw Failure("unknown choice", text, names);
  } else if (parameter.type == "double" && !value) {
    throw Failure("not a number", text, {parameter.description});
  } else if (parameter.type == "int" && !(value && *value == std::floor(*value) && std::abs(*value) < 2e9)) {
    throw Failure("not a whole number", text, {parameter.description});
  } else if (parameter.type == "dielectric_function" && !value && !isComplex(text) && !file) {
    throw Failure("neither a refractive index nor a file that is there", text,
                  {"n, (n,k), or a file of wavelength (um), n, k"});
  } else if (parameter.type == "Table" && !value && !file) {
    throw Failure("neither a number nor a file that is there", text, {"a number, or a file of two columns"});
  }
}

void appendTree(std::vector<ParameterFacts>& list, const SCATMECH::Model& model, const std::string& prefix) {
  for (const SCATMECH::ModelParameterBase* parameter : model.get_inheritance().get_parameters()) {
    const SCATMECH::Inheritance* kind = parameter->get_inheritance(nullptr);
    const SCATMECH::Model* inner = innerModel(*parameter, model);
    list.push_back({prefix + parameter->name, parameter->type,
                    kind && !inner ? std::string() : parameter->get_parameter(&model, ""), parameter->description,
                    kind ? namesOf(*kind) : std::vector<std::string>()});
    if (inner) appendTree(list, *inner, prefix + parameter->name + ".");
  }
}

/// Calls `body`; what SCATMECH throws becomes one line, without the listing of parameters that follows it.
template <class Body>
auto translated(Body&& body) {
  try {
    return body();
  } catch (const SCATMECH::SCATMECH_exception& error) {
    std::string text = error.what();
    if (text.rfind("SCATMECH: ", 0) == 0) text.erase(0, 10);
    throw Failure(text.substr(0, text.find('\n')));
  }
}

/// Calls `body` with a working directory of its own, which is deleted afterwards: some models write files when they set
/// themselves up (T-matrix scatterers shape.dat), over any of that name. Linux gives a thread its own directory without
/// moving the others; elsewhere, and where there is no temporary folder, `body` is called as it is.
template <class Body>
void inScratchFolder(Body&& body) {
#ifdef __linux__
  std::error_code ignored;
  std::string folder = (std::filesystem::temp_directory_path(ignored) / "brdflab-scatmech-XXXXXX").string();
  if (!ignored && mkdtemp(folder.data())) {
    std::exception_ptr failure;
    std::thread([&] {
      try {
        if (unshare(CLONE_FS) != 0 || chdir(folder.c_str()) != 0) throw Failure("no working directory", folder);
        body();
      } catch (...) {
        failure = std::current_exception();
      }
    }).join();
    std::filesystem::remove_all(folder, ignored);
    if (failure) std::rethrow_exception(failure);
    return;
  }
#endif
  body();
}

}  // namespace

std::mutex& inside() {
  static std::mutex mutex;
  return mutex;
}

std::vector<ModelFacts> allModels() {
  std::vector<ModelFacts> models;
  for (const SCATMECH::Inheritance* item : makeable(brdfModels()))
    models.push_back({item->get_name(), item->get_description()});
  return models;
}

struct Model::Implementation {
  std::unique_ptr<SCATMECH::BRDF_Model> model;
  bool ready = false;  ///< set up, since a parameter was changed
};

Model::Model(const std::string& name) : implementation_(std::make_unique<Implementation>()) {
  for (const SCATMECH::Inheritance* item : makeable(brdfModels()))
    if (item->get_name() == name)
      implementation_->model.reset(translated([&] { return static_cast<SCATMECH::BRDF_Model*>(item->make()); }));
  if (!implementation_->model) throw Failure("unknown model", name, namesOf(brdfModels()));
}

Model::~Model() = default;
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;

const std::string& Model::description() const { return implementation_->model->get_inheritance().get_description(); }

std::vector<ParameterFacts> Model::parameters() const {
  return translated([&] {
    std::vector<ParameterFacts> list;
    appendTree(list, *implementation_->model, "");
    return list;
  });
}

void Model::set(const std::string& parameter, const std::string& text) {
  translated([&] {
    checkText(findParameter(*implementation_->model, parameter), text);
    // Files keep their meaning whatever the working directory is when they are read.
    std::error_code ignored;
    const bool file = std::filesystem::is_regular_file(text, ignored);
    implementation_->ready = false;
    implementation_->model->set_parameter(parameter, file ? std::filesystem::absolute(text).string() : text);
  });
}

void Model::setWavelength(double micrometres) {
  implementation_->ready = false;
  implementation_->model->set_lambda(micrometres);
}

void Model::mueller(double thetaI, double thetaS, double phiS, double rotation, double* m) {
  const auto ask = [&] {
    const SCATMECH::MuellerMatrix mueller =
        implementation_->model->Mueller(thetaI, thetaS, phiS, rotation, SCATMECH::BRDF_Model::psps);
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) m[4 * row + column] = mueller[row][column];
  };
  translated([&] {
    if (implementation_->ready) return ask();
    inScratchFolder(ask);
    implementation_->ready = true;
  });
}

}  // namespace scatmech

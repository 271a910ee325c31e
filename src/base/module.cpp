// SPDX-License-Identifier: Apache-2.0
#include "base/module.h"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>

namespace aresta {

namespace {

std::vector<std::filesystem::path> module_folders() {
  std::vector<std::filesystem::path> folders;
  if (const char* path = std::getenv("ARESTA_MODULE_PATH")) folders.emplace_back(path);
  Dl_info info;
  if (dladdr(reinterpret_cast<void*>(&module_function), &info) != 0 && info.dli_fname != nullptr) {
    std::error_code ignored;
    const auto here = std::filesystem::canonical(info.dli_fname, ignored).parent_path();
    for (const char* folder : {"aresta", "modules", "../modules", "../../modules"}) folders.push_back(here / folder);
  }
  return folders;
}

Result<void*> load(const std::string& name) {
  const std::string file = "libaresta_" + name + ".so";
  std::string reason = "no file " + file + " in the module folders";
  for (const auto& folder : module_folders()) {
    const auto path = folder / file;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) continue;
    if (void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL)) return handle;
    reason = dlerror();
  }
  return Error{errors::module_missing,
               "module " + name + " cannot be loaded: " + reason,
               {},
               {},
               "set ARESTA_MODULE_PATH to the folder that holds " + file};
}

}  // namespace

Result<void*> module_function(const std::string& name, const std::string& symbol) {
  static std::mutex mutex;
  static std::map<std::string, void*> loaded;
  const std::lock_guard lock(mutex);
  auto found = loaded.find(name);
  if (found == loaded.end()) {
    ARESTA_TRY(void* handle, load(name));
    found = loaded.emplace(name, handle).first;
  }
  void* function = dlsym(found->second, symbol.c_str());
  if (function == nullptr) return Error{errors::module_missing, "module " + name + " has no function " + symbol};
  return function;
}

}  // namespace aresta

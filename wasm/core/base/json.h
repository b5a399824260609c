#pragma once

#include <cstdio>
#include <string>

namespace whittle {

/// A number as JSON, from which the very same bits are read.
inline std::string jsonNumber(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// A string as JSON; of characters that need escaping it must have none.
inline std::string jsonString(const std::string& text) { return "\"" + text + "\""; }

/// A list as JSON of items that `toJson` makes JSON of.
template <typename Items, typename ToJson>
std::string jsonList(const Items& items, ToJson toJson) {
  std::string json = "[";
  for (const auto& item : items) json += (json.size() > 1 ? "," : "") + toJson(item);
  return json + "]";
}

/// An object of JSON, written front to back.
class Json {
 public:
  Json& add(const char* key, double value) { return addJson(key, jsonNumber(value)); }
  Json& add(const char* key, const std::string& text) { return addJson(key, jsonString(text)); }
  Json& add(const char* key, const Json& object) { return addJson(key, object.text()); }
  /// Adds a value that is JSON already.
  Json& addJson(const char* key, const std::string& json) {
    body_ += (body_.empty() ? "\"" : ",\"") + std::string(key) + "\":" + json;
    return *this;
  }
  std::string text() const { return "{" + body_ + "}"; }

 private:
  std::string body_;
};

}  // namespace whittle

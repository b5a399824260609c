#include "base/status.h"

#include <doctest/doctest.h>

using namespace whittle;

TEST_CASE("a failure's number stands in its sentence and in its element") {
  const Status status = Status::failure(Code::badHandles, "vertex {} is held, and {} again", Element::vertex(3));
  const Status numbered = status.numbered(17);
  CHECK(numbered.message == "vertex 17 is held, and 17 again");
  CHECK(numbered.element.index == 17);
  CHECK(numbered.element.kind == Element::Kind::vertex);
  CHECK(numbered.code == Code::badHandles);
}

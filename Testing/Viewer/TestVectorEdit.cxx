#include "Catch.h"
#include "NumberBox.h"
#include "VectorEdit.h"
#include "ViewerSession.h"

#include <QLineEdit>
#include <QTest>

using namespace penumbra;

TEST_CASE("Of a vector one component is edited, and the others keep the digits that are not shown")
{
  VectorEdit edit({ -10.0, 10.0, 3 });
  edit.SetNames("Place", "");
  edit.ShowVector({ 1.0, 1.0 / 3.0, -2.0e-5 });
  Vector3 edited{};
  QObject::connect(&edit, &VectorEdit::edited, [&](const Vector3& vector) { edited = vector; });
  auto* const box = edit.findChild<NumberBox*>("Place x");
  TypeText(box->findChild<QLineEdit*>(), "2.5");
  QTest::keyClick(box, Qt::Key_Return);
  CHECK(edited == Vector3{ 2.5, 1.0 / 3.0, -2.0e-5 });
}

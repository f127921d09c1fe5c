#include "ReadingProgress.h"

#include "SceneOpening.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace penumbra
{
namespace
{
constexpr int Steps = 1000;
}

//------------------------------------------------------------------------------
ReadingProgress::ReadingProgress(SceneOpening* opening, QWidget* parent)
  : QWidget(parent)
  , Label(new QLabel(this))
  , Bar(new QProgressBar(this))
{
  this->setObjectName("readingProgress");
  auto* const layout = new QHBoxLayout(this);
  layout->setContentsMargins(4, 0, 4, 0);
  layout->addWidget(this->Label);
  layout->addWidget(this->Bar);
  auto* const cancel = new QPushButton(tr("Cancel"), this);
  cancel->setObjectName("cancelReading");
  cancel->setToolTip(tr("Stop reading; what is open stays (Esc)"));
  cancel->setShortcut(Qt::Key_Escape);
  layout->addWidget(cancel);
  this->Bar->setAccessibleName(tr("Progress of reading"));
  this->Bar->setRange(0, Steps);
  this->Bar->setFixedWidth(220);
  this->connect(cancel, &QPushButton::clicked, opening, &SceneOpening::Cancel);
  this->connect(opening, &SceneOpening::progressed, this,
    [this](double part) { this->Bar->setValue(qRound(part * Steps)); });
  this->connect(opening, &SceneOpening::opened, this, &QWidget::hide);
  this->connect(opening, &SceneOpening::failed, this, &QWidget::hide);
  this->connect(opening, &SceneOpening::canceled, this, &QWidget::hide);
  this->connect(opening, &SceneOpening::seriesFound, this, &QWidget::hide);
  this->hide();
}

//------------------------------------------------------------------------------
void ReadingProgress::Begin(const QString& file)
{
  this->Label->setText(tr("Reading %1").arg(file));
  this->Bar->setValue(0);
  this->show();
}

}

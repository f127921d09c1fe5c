/**
 * @file    EmptySpaceTexture.h
 * @brief   the empty cubes of bricks as a small 3D texture, for rays that leap
 *
 * The bricks' ranges are computed once per volume; occupancy and cubes when what is visible
 * changes. Clipping planes and a cropping box need no bricks: rays are cut there.
 */

#ifndef EmptySpaceTexture_h
#define EmptySpaceTexture_h

#include "EmptySpace.h"
#include "ScalarBricks.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

#include <array>
#include <vector>

class vtkDataArray;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace penumbra
{

struct ScalarRange;
struct TransferFunctionTable;

/// What leaping works with.
struct EmptySpaceReport
{
  int BrickEdge = 0;
  int Bricks = 0;
  int OccupiedBricks = 0;
  /// Mean over the occupied bricks of the largest extinction in each.
  double MeanExtinction = 0.0;
  TextureBox Matter; ///< around the occupied bricks

  /// The placement with its box drawn in around the occupied bricks.
  VolumePlacement DrawIn(const VolumePlacement& placement) const;

  /// Whether rays have enough to leap over to make up for the look-ups.
  bool Helps() const;
};

class EmptySpaceTexture
{
public:
  /// The volume has changed: its ranges are computed when they are next needed.
  void ForgetScalars();
  bool HasBricks() const { return !this->Bricks.Low.empty(); }
  void ComputeBricks(
    vtkDataArray* scalars, const std::array<int, 3>& dimensions, const ScalarRange& range);
  const BrickGrid& GetGrid() const { return this->Bricks.Grid; }
  /// Finds what the table makes visible and loads the cubes.
  void Load(vtkOpenGLRenderWindow* window, const TransferFunctionTable& table,
    const BrickVisibility& visibility);
  const EmptySpaceReport& GetReport() const { return this->Report; }
  /// Around all that is visible, see FindOuterBricks.
  const std::vector<int>& GetOuterBricks() const { return this->OuterBricks; }

  vtkTextureObject* GetTexture() const { return this->Texture; }
  void SetUniforms(vtkShaderProgram* program) const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  vtkNew<vtkTextureObject> Texture;
  ScalarBricks Bricks;
  EmptySpaceReport Report;
  std::vector<int> OuterBricks;
};

}

#endif

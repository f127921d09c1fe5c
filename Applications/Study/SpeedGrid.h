/**
 * @file    SpeedGrid.h
 * @brief   what the speed study draws: scenes, sizes, lights and ways to draw them
 */

#ifndef SpeedGrid_h
#define SpeedGrid_h

#include "StudyScenes.h"

#include <optional>
#include <string>
#include <vector>

namespace penumbra
{

struct SpeedScene
{
  std::string Name;
  std::filesystem::path File;
  /// The stated bounds are for this one.
  bool HasBounds = false;
  /// Drawn in several sizes and with several lights too, where not the whole grid is asked for.
  bool HasAxes = false;
};

/// One scene in one size, in one picture size, by a number of lights.
struct SpeedCell
{
  SpeedScene Scene;
  /// Voxels along the longest edge. 0: as many as the volume has.
  int Edge = 0;
  /// Pixels along each edge.
  int Image = 512;
  /// Copies of the scene's first light, turned about the volume.
  int Lights = 1;

  /// The volume in its own size, with one light at 512 x 512 pixels: what bounds are stated for.
  bool IsPlain() const { return this->Edge == 0 && this->Image == 512 && this->Lights == 1; }
  /// The same with four lights, which are held against one.
  bool IsPlainOfFourLights() const
  {
    return this->Edge == 0 && this->Image == 512 && this->Lights == 4;
  }
};

/// How a cell is drawn.
struct SpeedRequest
{
  /// Each as after penumbra-render's --set.
  std::vector<std::string> Settings;
  /// Of view rays and of shadow rays, in the smallest voxel spacing.
  double Step = 1.0;
  double ShadowStep = 1.0;
  /// Not the cell's copies of the first light, but it.
  bool HasOneLight = false;
};

constexpr int UsualRounds = 3;
/// Of auto's frames of four lights and of one, whose bound is near what is measured.
constexpr int RoundsOfFourLights = 9;

struct SpeedVariant
{
  std::string Name;
  SpeedRequest Request;
  /// What the picture is held against.
  std::optional<SpeedRequest> Truth;
  /// Frames after edits of light and opacity are timed too.
  bool HasEdits = false;
  /// How often its frames are timed.
  int Rounds = UsualRounds;
};

/// The frame that all others are multiples of: the stock mapper's, unlit.
extern const char* const StockUnlit;
/// What several lights are held against, in turn with them.
extern const char* const AutoOfOneLight;

/**
 * The variants of a cell, the stock unlit frame first. `full` adds the techniques' resolutions,
 * edits of hard shadows and beside the plain cells, and all techniques with several lights in
 * scenes without axes.
 */
std::vector<SpeedVariant> GetSpeedVariants(const SpeedCell& cell, bool full);

/**
 * Every scene plainly, and for those with axes one thing changed at a time: edge, lights, image;
 * `full` is the product of edges and lights for all scenes, and the images.
 */
std::vector<SpeedCell> MakeSpeedGrid(const std::vector<SpeedScene>& scenes, bool full);

}

#endif

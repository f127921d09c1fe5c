#include "ViewTiles.h"

#include "EmptySpace.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace penumbra
{
namespace
{
// A brick's clip coordinates: those of its middle, and how far its corners are from there at most.
struct ClipBox
{
  Vector3 Middle{}; // x, y, w
  Vector3 Reach{};
};

struct Interval
{
  double Low = 0.0;
  double High = 0.0;
};

class BrickProjection
{
public:
  BrickProjection(const BrickGrid& grid, const Matrix4& textureToClip)
    : Grid(grid)
  {
    const auto [scale, offset] = MapToBricks(grid);
    constexpr int rows[3] = { 0, 1, 3 };
    for (int row = 0; row < 3; ++row)
    {
      const double* factors = &textureToClip[4 * rows[row]];
      this->First.Middle[row] = factors[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        // A single voxel's brick is as thick as the texture.
        const bool isFlat = scale[axis] == 0.0;
        const double edge = isFlat ? 1.0 : 1.0 / scale[axis];
        const double begin = isFlat ? 0.0 : -offset[axis] / scale[axis];
        this->Steps[axis][row] = factors[axis] * edge;
        this->First.Middle[row] += factors[axis] * (begin + 0.5 * edge);
        this->First.Reach[row] += 0.5 * std::abs(factors[axis] * edge);
      }
    }
  }

  ClipBox Project(int brick) const
  {
    const auto& counts = this->Grid.Counts;
    const int at[3] = { brick % counts[0], brick / counts[0] % counts[1],
      brick / (counts[0] * counts[1]) };
    ClipBox box = this->First;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int row = 0; row < 3; ++row)
      {
        box.Middle[row] += at[axis] * this->Steps[axis][row];
      }
    }
    return box;
  }

private:
  const BrickGrid& Grid;
  ClipBox First;
  Vector3 Steps[3];
};

// Bounds of x / w over a box that lies before the eye.
Interval Divide(const ClipBox& box, int row)
{
  const double low = box.Middle[row] - box.Reach[row];
  const double high = box.Middle[row] + box.Reach[row];
  const double nearest = box.Middle[2] - box.Reach[2];
  const double farthest = box.Middle[2] + box.Reach[2];
  return { low / (low < 0.0 ? nearest : farthest), high / (high < 0.0 ? farthest : nearest) };
}

// In tiles; columns and rows behind the last.
struct TileRectangle
{
  int Left = 0;
  int Low = 0;
  int Right = 0;
  int High = 0;

  int GetArea() const { return (this->Right - this->Left) * (this->High - this->Low); }
};

// Square tiles of pixels, marked or not.
class TileGrid
{
public:
  TileGrid(int width, int height, int edge)
    : Size{ width, height }
    , Edge(edge)
    , Columns((width + edge - 1) / edge)
    , Rows((height + edge - 1) / edge)
    , Marked(static_cast<std::size_t>(this->Columns) * static_cast<std::size_t>(this->Rows))
  {
  }

  void Mark(const Interval& x, const Interval& y)
  {
    const auto [left, right] = this->FindTiles(x, this->Size[0], this->Columns);
    const auto [low, high] = this->FindTiles(y, this->Size[1], this->Rows);
    this->Fill({ left, low, right, high }, 1);
  }

  // The largest first: rasterizers draw rectangles as two triangles, and what lies on the diagonal
  // between them may cost twice. No value where they are too many.
  std::optional<std::vector<std::array<float, 4>>> MakeRectangles()
  {
    std::vector<std::array<float, 4>> rectangles;
    for (TileRectangle tiles = this->FindLargest(); tiles.GetArea() > 0;
         tiles = this->FindLargest())
    {
      if (rectangles.size() == ViewTiles::Most)
      {
        return std::nullopt;
      }
      rectangles.push_back({ this->ToDevice(tiles.Left, 0), this->ToDevice(tiles.Low, 1),
        this->ToDevice(tiles.Right, 0), this->ToDevice(tiles.High, 1) });
      this->Fill(tiles, 0);
    }
    return rectangles;
  }

private:
  // First and behind the last. A pixel more on each side is for rounding.
  std::array<int, 2> FindTiles(const Interval& interval, int pixels, int tiles) const
  {
    const auto find = [&](double position, double margin)
    {
      const double tile = ((0.5 * position + 0.5) * pixels + margin) / this->Edge;
      return static_cast<int>(std::clamp(std::floor(tile), -1.0, 1.0 * tiles));
    };
    return { std::max(find(interval.Low, -1.0), 0), std::min(find(interval.High, 1.0) + 1, tiles) };
  }

  void Fill(const TileRectangle& tiles, unsigned char mark)
  {
    for (int row = tiles.Low; row < tiles.High && tiles.Left < tiles.Right; ++row)
    {
      const auto begin = this->Marked.begin() + static_cast<std::ptrdiff_t>(row) * this->Columns;
      std::fill(begin + tiles.Left, begin + tiles.Right, mark);
    }
  }

  // Of all marked tiles. Each column is as high, from this row down, as its tiles are marked; a
  // rectangle ends where a lower column follows.
  TileRectangle FindLargest() const
  {
    struct Step
    {
      int Left;
      int Height;
    };
    TileRectangle largest;
    std::vector<int> heights(this->Columns);
    std::vector<Step> steps;
    for (int row = 0; row < this->Rows; ++row)
    {
      for (int column = 0; column <= this->Columns; ++column)
      {
        int height = 0;
        if (column < this->Columns)
        {
          const bool isMarked =
            this->Marked[static_cast<std::size_t>(row) * this->Columns + column];
          height = heights[column] = isMarked ? heights[column] + 1 : 0;
        }
        int left = column;
        while (!steps.empty() && steps.back().Height >= height)
        {
          left = steps.back().Left;
          const TileRectangle tiles = { left, row + 1 - steps.back().Height, column, row + 1 };
          largest = tiles.GetArea() > largest.GetArea() ? tiles : largest;
          steps.pop_back();
        }
        if (height > 0)
        {
          steps.push_back({ left, height });
        }
      }
    }
    return largest;
  }

  float ToDevice(int tile, int axis) const
  {
    const int pixel = std::min(tile * this->Edge, this->Size[axis]);
    return 2.0f * static_cast<float>(pixel) / static_cast<float>(this->Size[axis]) - 1.0f;
  }

  const std::array<int, 2> Size;
  const int Edge;
  const int Columns;
  const int Rows;
  std::vector<unsigned char> Marked;
};

constexpr int LeastEdge = 8;
constexpr int MostColumns = 64;
}

//------------------------------------------------------------------------------
ViewTiles FindViewTiles(const std::vector<int>& bricks, const BrickGrid& grid,
  const Matrix4& textureToClip, int width, int height)
{
  const BrickProjection projection(grid, textureToClip);
  std::vector<std::array<Interval, 2>> places;
  for (const int brick : bricks)
  {
    const ClipBox box = projection.Project(brick);
    const bool isBehind = box.Middle[2] + box.Reach[2] <= 0.0;
    const bool isBefore = box.Middle[2] - box.Reach[2] > 0.0;
    if (!isBehind && !isBefore)
    {
      return { true, {} };
    }
    if (isBefore)
    {
      places.push_back({ Divide(box, 0), Divide(box, 1) });
    }
  }
  const int longest = std::max(width, height);
  for (int edge = std::max(LeastEdge, (longest + MostColumns - 1) / MostColumns);; edge *= 2)
  {
    TileGrid picture(width, height, edge);
    for (const auto& [x, y] : places)
    {
      picture.Mark(x, y);
    }
    if (const auto rectangles = picture.MakeRectangles())
    {
      return { false, *rectangles };
    }
  }
}

}

vec4 accumulatedBefore()
{
  return vec4(0.0);
}

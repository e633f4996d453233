#version 460

// Depth only: all lines have one color.
void main()
{
}

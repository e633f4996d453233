#version 460

// Depth only: all lines have one colour.
void main()
{
}

# Lets the lines of a comment that begin with Complexity or Source be paragraphs of their own in the manual.
{
  sub(/\/\/\/ Complexity:/, "/// \\complexity")
  sub(/\/\/\/ Source:/, "/// \\source")
  print
}

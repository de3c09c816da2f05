# Makes a page of Markdown one of the manual's: gives every heading the id by which links call it, as code hosts do by
# themselves, and a page without a title the name of its file. In Doxygen an id begins with a letter and is one for all
# pages, hence the prefix.
NR == 1 && !/^# / {
  title = FILENAME
  gsub(/.*\/|\.md$/, "", title)
  gsub(/_/, " ", title)
  print "# " toupper(substr(title, 1, 1)) substr(title, 2) "\n"
}
/^##? / {
  id = tolower($0)
  gsub(/^#+ |[^a-z0-9 -]/, "", id)
  gsub(/ /, "-", id)
  $0 = $0 " {#section-" id "}"
}
{
  gsub(/\]\(#/, "](#section-")
  print
}

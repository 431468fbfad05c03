package dev.eventchain.lsp.project;

import java.util.List;
import java.util.Set;

/**
 * A cursor in YAML, and what can be written there.
 *
 * @param path the keys around it, with {@link #ITEM} for an element of a list
 * @param keys the keys that the mapping at the path has already
 * @param takesKeys true if a key of the mapping at the path can stand here
 * @param takesValue true if a scalar value of the path can stand here
 * @param isFlow true in brackets
 * @param start the offset of the word at the cursor
 * @param end the end of this word
 * @param extra how much farther to the right it stands than its line begins
 */
record YamlPlace(
    List<String> path,
    Set<String> keys,
    boolean takesKeys,
    boolean takesValue,
    boolean isFlow,
    int start,
    int end,
    int extra) {

  /** The step from a list to any of its elements. */
  static final String ITEM = "[]";

  /** The step from a mapping to the value of a key of any name; no key has an empty one. */
  static final String ANY = "";

  YamlPlace {
    path = List.copyOf(path);
    keys = Set.copyOf(keys);
  }

  /** Returns the last step of the path that is no element of a list; empty if there is none. */
  String lastKey() {
    return path.stream().filter(each -> !each.equals(ITEM)).reduce("", (first, next) -> next);
  }
}

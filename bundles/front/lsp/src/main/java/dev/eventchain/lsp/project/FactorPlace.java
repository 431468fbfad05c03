package dev.eventchain.lsp.project;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A place in a campaign file where the path of a number belongs.
 *
 * @param campaign the steps to the campaign, none if the file has only one
 */
record FactorPlace(List<String> campaign) {

  private static final Set<String> OF_FACTORS = Set.of("factors", "computed");

  /** Returns what a place is for; empty if it is no place for a path. */
  static Optional<FactorPlace> of(YamlPlace place) {
    List<String> path = new ArrayList<>(place.path());
    int last = path.size() - 1;
    if (last > 0 && path.get(last).equals(YamlPlace.ITEM) && path.get(last - 1).equals("paths")) {
      path.remove(last);
    } else if (last < 0 || !path.get(last).equals("path")) {
      return Optional.empty();
    }
    // ..., factors, its name, path
    int factors = path.size() - 3;
    return factors >= 0 && OF_FACTORS.contains(path.get(factors))
        ? Optional.of(new FactorPlace(List.copyOf(path.subList(0, factors))))
        : Optional.empty();
  }

  /** Returns the scenario that the campaign names; empty if there is none. */
  String scenario(YamlText text) {
    List<String> path = new ArrayList<>(campaign);
    path.add("scenario");
    return text.scalar(path);
  }
}

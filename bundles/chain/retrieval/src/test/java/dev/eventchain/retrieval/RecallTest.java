package dev.eventchain.retrieval;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.eventchain.catalogue.SignalCatalogue;
import dev.eventchain.catalogue.SignalGroup;
import dev.eventchain.catalogue.signal.CatalogueSource;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/**
 * The recall of retrieval for labelled sentences: the share of the signals that they need which is
 * among the first 16 and 40.
 */
class RecallTest {

  private static final Path WHOLE = Path.of("../../../examples/child-presence/catalogue/vss.json");
  private static final Path NEEDS = Path.of("src/test/resources/needs.tsv");
  private static final int SHORT = 16;
  private static final int LONG = 40;

  private static final List<SignalGroup> GROUPS =
      SignalGroup.of(
          SignalCatalogue.read(new CatalogueSource(WHOLE, List.of(), Optional.empty()))
              .signals()
              .stream()
              .filter(signal -> signal.type().isPresent())
              .toList());

  /** Hits among the first ones, and all that are needed. */
  private static final class Counts {
    private int inShort;
    private int inLong;
    private int all;

    @Override
    public String toString() {
      return String.format(
          Locale.ROOT, "%.2f at 16, %.2f at 40, of %d", share(inShort), share(inLong), all);
    }

    private double share(int hits) {
      return (double) hits / all;
    }
  }

  @Test
  void findsWhatSentencesNeed() throws IOException {
    assertEquals(
        """
        a: 0.96 at 16, 1.00 at 40, of 51
        b: 0.98 at 16, 1.00 at 40, of 55
        c: 0.73 at 16, 0.78 at 40, of 41
        """,
        recall(new SignalIndex(GROUPS, Synonyms.shipped())));
  }

  /** What the synonyms are worth. */
  @Test
  void findsLessWithoutSynonyms() throws IOException {
    assertEquals(
        """
        a: 0.61 at 16, 0.67 at 40, of 51
        b: 0.78 at 16, 0.80 at 40, of 55
        c: 0.63 at 16, 0.76 at 40, of 41
        """,
        recall(new SignalIndex(GROUPS, Synonyms.none())));
  }

  private static String recall(SignalIndex index) throws IOException {
    Map<String, Counts> bySet = new TreeMap<>();
    for (String line : Files.readAllLines(NEEDS)) {
      if (!line.startsWith("#")) {
        String[] columns = line.split("\t", -1);
        List<SignalGroup> found = index.find(columns[2], LONG);
        for (String path : columns[3].split(", ", -1)) {
          count(bySet.computeIfAbsent(columns[0], key -> new Counts()), rank(path, found));
        }
      }
    }
    return bySet.entrySet().stream()
        .map(each -> each.getKey() + ": " + each.getValue() + "\n")
        .collect(Collectors.joining());
  }

  private static void count(Counts counts, int rank) {
    counts.all++;
    counts.inShort += rank < SHORT ? 1 : 0;
    counts.inLong += rank < LONG ? 1 : 0;
  }

  private static int rank(String path, List<SignalGroup> found) {
    Pattern wanted = Pattern.compile(Pattern.quote(path).replace("*", "\\E.*\\Q"));
    for (int rank = 0; rank < found.size(); rank++) {
      if (found.get(rank).signals().stream().anyMatch(it -> wanted.matcher(it.path()).matches())) {
        return rank;
      }
    }
    return Integer.MAX_VALUE;
  }
}

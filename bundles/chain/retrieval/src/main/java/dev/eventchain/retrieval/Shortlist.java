package dev.eventchain.retrieval;

import dev.eventchain.catalogue.SignalCatalogue;
import dev.eventchain.catalogue.SignalGroup;
import dev.eventchain.catalogue.signal.CatalogueSignal;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The signals of a catalogue that a function may need: for each of its texts, and for each clause
 * of a text, the best ones, joined by their ranks, since scores of different texts cannot be
 * compared. The best rank of a signal counts: what one clause alone needs is needed, however many
 * others speak of something else.
 *
 * @param entries the pinned ones, and then the others by their scores
 */
public record Shortlist(List<Entry> entries) {

  /** Number of the best signals of a text that count. */
  private static final int DEPTH = 50;

  /** The rank, counted from 0, at which a score is half of that of the first one. */
  private static final double HALF = 10;

  /** Weight of all ranks, which decides between signals with the same best rank. */
  private static final double OF_OTHERS = 0.001;

  private static final Pattern CLAUSES =
      Pattern.compile(
          "[,;:.]\\s|\\b(?:and|or|while|when|if|after|before|until|because|as long as)\\b");

  /** Weight of a text that describes software which is there already. */
  private static final double OF_SOFTWARE = 0.5;

  /**
   * A text that signals are looked for with.
   *
   * @param name the id of a requirement, or the name of a component
   * @param isRequired whether it is asked for, and not there already
   */
  public record Text(String name, String text, boolean isRequired) {}

  /**
   * A group of signals on the list.
   *
   * @param score 1 if it is the best for a text or clause, 0.5 at rank 10, half of it for texts of
   *     software that is there; plus a little for other texts
   * @param because the name of the text to which it owes the most; empty if to none
   * @param isPinned whether it is on the list whatever its score
   */
  public record Entry(SignalGroup group, double score, String because, boolean isPinned) {}

  /** Copies the list. */
  public Shortlist {
    entries = List.copyOf(entries);
  }

  /**
   * Returns the list for texts.
   *
   * @param count the number of entries, more if more are pinned
   * @param pinned paths of signals or of groups of them that are always on the list
   * @param excluded such paths that are never on it
   */
  public static Shortlist of(
      SignalCatalogue catalogue,
      List<Text> texts,
      int count,
      List<String> pinned,
      List<String> excluded) {
    List<CatalogueSignal> offered =
        catalogue.signals().stream()
            .filter(it -> !catalogue.topics(List.of(it)).isEmpty())
            .filter(it -> excluded.stream().noneMatch(path -> SignalCatalogue.isIn(it, path)))
            .toList();
    List<SignalGroup> groups = SignalGroup.of(offered);
    SignalIndex index = new SignalIndex(groups, Synonyms.shipped());
    Map<SignalGroup, Tally> tallies = new LinkedHashMap<>();
    groups.forEach(group -> tallies.put(group, new Tally(group, pinned)));
    for (Text text : texts) {
      for (String part : parts(text.text())) {
        List<SignalGroup> found = index.find(part, DEPTH);
        for (int rank = 0; rank < found.size(); rank++) {
          tallies.get(found.get(rank)).add(text, rank);
        }
      }
    }
    List<Entry> ranked =
        tallies.values().stream()
            .map(Tally::entry)
            .filter(it -> it.isPinned() || it.score() > 0)
            .sorted(
                Comparator.comparing(Entry::isPinned)
                    .reversed()
                    .thenComparing(Comparator.comparingDouble(Entry::score).reversed()))
            .toList();
    long kept = Math.max(count, ranked.stream().filter(Entry::isPinned).count());
    return new Shortlist(ranked.stream().limit(kept).toList());
  }

  /** Returns a text, and its clauses if there are several. */
  private static List<String> parts(String text) {
    List<String> clauses = CLAUSES.splitAsStream(text).filter(it -> !it.isBlank()).toList();
    return clauses.size() < 2
        ? List.of(text)
        : Stream.concat(Stream.of(text), clauses.stream()).toList();
  }

  /** Returns the signals of all entries. */
  public List<CatalogueSignal> signals() {
    return entries.stream().flatMap(entry -> entry.group().signals().stream()).toList();
  }

  /** Ranks that the texts give a group. */
  private static final class Tally {
    private final SignalGroup group;
    private final boolean pinned;
    private String because = "";
    private double most;
    private double sum;

    Tally(SignalGroup group, List<String> pins) {
      this.group = group;
      this.pinned =
          pins.stream()
              .anyMatch(
                  pin -> group.signals().stream().anyMatch(it -> SignalCatalogue.isIn(it, pin)));
    }

    void add(Text text, int rank) {
      double gain = (text.isRequired() ? 1 : OF_SOFTWARE) * HALF / (HALF + rank);
      sum += gain;
      if (gain > most) {
        most = gain;
        because = text.name();
      }
    }

    Entry entry() {
      return new Entry(group, most + OF_OTHERS * sum, because, pinned);
    }
  }
}

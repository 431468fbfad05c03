package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;

/**
 * Evidence of which words with a number are ids of requirements in texts, and which are names, such
 * as {@code UTF-8}. An id's kind is what stands in front of its number. Rows of tables, directives,
 * the choice of a project and what is said below a heading, such as a status, prove a kind; a colon
 * does, and so do several headings, unless the word is a usual name.
 */
final class TextKinds {

  /** Words in front of numbers that are versions, parts of a text, standards or encodings. */
  private static final Set<String> NAMES =
      Set.of(
          ("v ver version release rev revision phase step stage sprint milestone iteration level"
                  + " part section chapter table figure fig appendix annex note example option page"
                  + " utf ucs iso iec ieee rfc aes sha rsa din sae ansi fips cve cwe misra itu etsi"
                  + " ecma")
              .split(" "));

  /** Last words of compound kinds, such as {@code ISO-REQ}, that no usual name has. */
  private static final Pattern OF_REQUIREMENTS =
      Pattern.compile("(?i)[a-z]*req|reqs|requirements?|fr|nfr|sr|fsr|tsr|hsr|ssr|sg|stkh");

  private static final Pattern REQUIRED =
      Pattern.compile(
          "(?i)\\b(?:shall|must|should|will|(?:has|have|needs?) to|(?:is|are) required"
              + "|soll|sollen|muss|müssen|darf|dürfen|doit|doivent)\\b");

  private final Reading reading;
  private final Set<String> proved = new HashSet<>();

  /** Ids of headings, by their kinds. */
  private final Map<String, Set<String>> headings = new HashMap<>();

  /** Ids of headings whose texts require something. */
  private final Set<String> required = new HashSet<>();

  private final Map<String, SourceLocation> passed = new LinkedHashMap<>();
  private TextIds.Named open;
  private int level;
  private boolean isAside;

  TextKinds(Reading reading) {
    this.reading = reading;
    proved.addAll(reading.types);
  }

  /** Returns whether a text requires something. */
  static boolean isRequirement(String text) {
    return REQUIRED.matcher(text).find();
  }

  /**
   * Returns whether an id begins with a usual name and does not end with a word for requirements.
   */
  static boolean isName(String id) {
    String[] words = kind(id).toLowerCase(Locale.ROOT).split("[-_./]", -1);
    return NAMES.contains(words[0]) && !OF_REQUIREMENTS.matcher(words[words.length - 1]).matches();
  }

  static String kind(String id) {
    return TextIds.prefix(id).orElse("");
  }

  /** Takes the blocks of a text as evidence. */
  void see(List<TextBlock> blocks) {
    open = null;
    blocks.forEach(this::see);
  }

  private void see(TextBlock block) {
    if (block instanceof TextBlock.Heading heading) {
      see(heading);
    } else if (block instanceof TextBlock.Lines lines) {
      lines.lines().forEach(this::see);
    } else if (block instanceof TextBlock.Table table) {
      TableColumns columns = new TableColumns(table, reading.fields);
      boolean isOfItems = columns.hasIds() && columns.hasTexts();
      if (isOfItems) {
        table.rows().forEach(row -> prove(columns.id(row), true));
      } else {
        table
            .rows()
            .forEach(
                row -> support(String.join(row.cells().size() == 2 ? ": " : " ", row.cells())));
      }
    } else if (block instanceof TextBlock.Directive directive) {
      prove(directive.options().getOrDefault(reading.fields.id().orElse("id"), ""), true);
    } else if (block instanceof TextBlock.Included included) {
      included.blocks().forEach(this::see);
    }
  }

  /** Opens a heading with an id, or goes on below the one that is open. */
  private void see(TextBlock.Heading heading) {
    Optional<TextIds.Named> named = TextIds.ofHeading(heading.text());
    if (named.isPresent()) {
      open = named.get();
      level = heading.level();
      headings.computeIfAbsent(kind(open.id()), kind -> new TreeSet<>()).add(open.id());
      prove(open.id(), !isName(open.id()) && TextIds.isMarked(heading.text(), open));
    } else if (heading.level() <= level) {
      open = null;
    }
    isAside = named.isEmpty() && TextOutline.isBeside(heading);
  }

  private void see(String line) {
    Optional<TextIds.Named> named = TextIds.ofLine(line);
    named.ifPresent(it -> prove(it.id(), !isName(it.id())));
    if (named.isEmpty()) {
      support(line);
    }
  }

  /** Takes what is said below a heading as evidence that it is that of an item. */
  private void support(String line) {
    if (open != null && !isAside) {
      boolean isFact =
          TextIds.ofFact(line).filter(it -> TextOutline.isKnown(it, reading.fields)).isPresent();
      prove(open.id(), isFact);
      if (isRequirement(line)) {
        required.add(open.id());
      }
    }
  }

  private void prove(String id, boolean isProof) {
    if (isProof && !kind(id).isEmpty()) {
      proved.add(kind(id));
    }
  }

  /** Returns whether a heading is that of an item. */
  boolean isHeading(TextIds.Named heading) {
    String id = heading.id();
    boolean several = headings.getOrDefault(kind(id), Set.of()).size() > 1;
    boolean isLikely = several || (required.contains(id) && Character.isUpperCase(id.charAt(0)));
    return proved.contains(kind(id)) || (!isName(id) && isLikely);
  }

  /** Returns whether a line that begins with an id and a colon is an item. */
  boolean isLine(TextIds.Named line) {
    return proved.contains(kind(line.id())) || !isName(line.id());
  }

  /** Keeps that an id is taken for a name. */
  void pass(TextIds.Named named, SourceText source, int line) {
    passed.putIfAbsent(named.id(), source.at(line, 1));
  }

  /** Reports what is taken for names, once for each kind. */
  void report() {
    if (!reading.types.isEmpty()) {
      return; // Items of these kinds would not count.
    }
    Map<String, List<String>> kinds = new LinkedHashMap<>();
    passed.keySet().forEach(id -> kinds.computeIfAbsent(kind(id), it -> new ArrayList<>()).add(id));
    kinds.forEach(this::report);
  }

  private void report(String kind, List<String> ids) {
    String first = ids.get(0);
    String others = ids.size() == 1 ? "" : " (and " + (ids.size() - 1) + " more like it)";
    String hint =
        isName(first)
            ? "If it is one, write it in a table with a column 'ID', or name its kind and all others"
                + " in eventchain.yaml: only: {type: [%s, ...]}"
            : "If it is one, write a colon behind it: '### %s: Title'.";
    reading.unread(
        "'%s'%s is taken for a name, not for the id of a requirement.".formatted(first, others),
        passed.get(first),
        hint.formatted(isName(first) ? kind : first),
        RequirementRules.UNREAD);
  }
}

package dev.eventchain.project;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.model.WrittenRequirement;
import dev.eventchain.project.requirements.RequirementRules;
import dev.eventchain.project.requirements.SourceRequirements;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Written requirements or design rules: the items {@code - REQ-1: text} of a Markdown file, in
 * their order, in which an item continues in indented lines and the rest is ignored, as is the box
 * of an entry in a task list; and after them, the requirements of sources in the formats of other
 * tools.
 *
 * @param items the items
 * @param diagnostics the findings: a duplicate id, an item without text, no item at all; as
 *     warnings, lines with a similar id that are no items
 */
public record Requirements(List<WrittenRequirement> items, List<Diagnostic> diagnostics) {

  private static final Pattern ITEM =
      Pattern.compile("[-*+] +(?:\\[[ xX]] +)?\\**([A-Za-z][A-Za-z0-9_.-]*)\\**:\\**\\s*(.*)");

  /** Common form of an id: a prefix and a number. */
  private static final Pattern NUMBERED = Pattern.compile("(.*?[A-Za-z])[-_. ]?([0-9]+)");

  /** Copies the lists. */
  public Requirements {
    items = List.copyOf(items);
    diagnostics = List.copyOf(diagnostics);
  }

  /** Returns the finding that there is no file of requirements although something names one. */
  static Diagnostic missing(Path file, String id) {
    return Diagnostic.of(
            FileRules.MISSING,
            "There is no such file, but the project names the requirement '" + id + "'.",
            SourceLocation.of(file))
        .withHint("Write each requirement into it: '- " + id + ": ...'");
  }

  /** Reads the items of a file. */
  public static Requirements read(SourceText source) {
    return read(source, List.of());
  }

  /**
   * Reads the items of a file.
   *
   * @param elsewhere the ids of items in other sources, which the file may mention
   */
  private static Requirements read(SourceText source, Collection<String> elsewhere) {
    return new Reader(source, elsewhere).read();
  }

  /**
   * Reads the items of a file, and after them those of sources in other formats.
   *
   * @param markdown the file, if there is one
   * @throws DiagnosticException INPUT if a source cannot be read at all
   */
  static Requirements read(Optional<SourceText> markdown, RequirementSources sources) {
    List<SourceRequirements> others = sources.all().stream().map(SourceRequirements::read).toList();
    List<String> known = others.stream().flatMap(each -> each.known().stream()).toList();
    Requirements written =
        markdown
            .map(text -> read(text, known))
            .orElseGet(() -> new Requirements(List.of(), List.of()));
    return others.isEmpty() ? written : written.with(others);
  }

  /**
   * Returns these requirements, and after them those of other sources. An id may be used once in
   * all of them; parents may be in any of them.
   */
  private Requirements with(List<SourceRequirements> sources) {
    List<WrittenRequirement> all = new ArrayList<>(items);
    List<Diagnostic> found = new ArrayList<>(diagnostics);
    List<String> known = new ArrayList<>(items.stream().map(WrittenRequirement::id).toList());
    Map<String, WrittenRequirement> seen = new HashMap<>();
    items.forEach(item -> seen.putIfAbsent(SourceRequirements.plainId(item.id()), item));
    for (SourceRequirements read : sources) {
      found.addAll(read.diagnostics());
      known.addAll(read.known());
      for (WrittenRequirement item : read.items()) {
        duplicate(item, seen.putIfAbsent(SourceRequirements.plainId(item.id()), item))
            .ifPresent(found::add);
        all.add(item);
      }
    }
    found.addAll(SourceRequirements.unknownParents(all, known));
    return new Requirements(all, found);
  }

  private static Optional<Diagnostic> duplicate(
      WrittenRequirement item, WrittenRequirement earlier) {
    if (earlier == null || item.id().isEmpty()) {
      return Optional.empty();
    }
    String message = "The id %s is already used in %s.".formatted(item.id(), earlier.location());
    return Optional.of(
        Diagnostic.of(RequirementRules.DUPLICATE, message, item.location())
            .withRelated(earlier.location())
            .withHint("Give each requirement an id of its own, or name only one of the sources."));
  }

  private static final class Reader {
    private final SourceText source;
    private final Collection<String> elsewhere;
    private final List<WrittenRequirement> items = new ArrayList<>();
    private final List<Diagnostic> diagnostics = new ArrayList<>();

    Reader(SourceText source, Collection<String> elsewhere) {
      this.source = source;
      this.elsewhere = elsewhere;
    }

    Requirements read() {
      int number = 0;
      boolean open = false;
      for (String line : source.text().lines().toList()) {
        number++;
        Matcher item = ITEM.matcher(line.stripTrailing());
        if (item.matches()) {
          items.add(
              new WrittenRequirement(item.group(1), item.group(2).strip(), source.at(number, 1)));
          open = true;
        } else if (open && line.startsWith("  ") && !line.isBlank()) {
          goOn(line.strip());
        } else {
          open = false;
        }
      }
      check();
      findUnread();
      return new Requirements(items, diagnostics);
    }

    private void goOn(String text) {
      WrittenRequirement last = items.remove(items.size() - 1);
      items.add(
          new WrittenRequirement(last.id(), (last.text() + " " + text).strip(), last.location()));
    }

    private void check() {
      if (items.isEmpty()) {
        diagnostics.add(
            Diagnostic.of(RequirementRules.NONE, "The file contains no requirement.", source.at(0))
                .withHint(
                    "Write each as an item with an id: '- REQ-1: The system shall ...'. Tables and"
                        + " headings are read of a file that eventchain.yaml names under"
                        + " 'requirements'."));
      }
      Map<String, WrittenRequirement> seen = new HashMap<>();
      for (WrittenRequirement item : items) {
        WrittenRequirement earlier = seen.putIfAbsent(SourceRequirements.plainId(item.id()), item);
        if (earlier != null) {
          find(
              RequirementRules.DUPLICATE,
              "The id " + item.id() + " is already used in line " + earlier.location().line() + ".",
              item);
        }
        if (item.text().isEmpty()) {
          find(RequirementRules.EMPTY, "The item " + item.id() + " has no text.", item);
        }
      }
    }

    /** Warns of lines with a similar id, which may be items in another notation. */
    private void findUnread() {
      Set<String> known = new HashSet<>();
      Set<String> kinds = new TreeSet<>();
      numbered(elsewhere.stream()).forEach(each -> known.add(plain(each)));
      numbered(items.stream().map(WrittenRequirement::id))
          .forEach(
              each -> {
                kinds.add(Pattern.quote(each.group(1)));
                known.add(plain(each));
              });
      if (kinds.isEmpty()) {
        return;
      }
      String kind = "(?i)(?<![A-Za-z0-9_-])(" + String.join("|", kinds) + ")[-_. ]?([0-9]+)";
      Matcher found = Pattern.compile(kind).matcher(source.text());
      while (found.find()) {
        if (known.add(plain(found))) {
          diagnostics.add(
              Diagnostic.of(
                      RequirementRules.UNREAD,
                      "No item has the id '%s'.".formatted(found.group()),
                      source.at(found.start()))
                  .withHint(
                      "If it should be one, write: '- ID: text'; items continue in indented"
                          + " lines."));
        }
      }
    }

    private static Stream<Matcher> numbered(Stream<String> ids) {
      return ids.map(NUMBERED::matcher).filter(Matcher::matches);
    }

    private static String plain(Matcher numbered) {
      return numbered.group(1).toLowerCase(Locale.ROOT) + "-" + numbered.group(2);
    }

    private void find(Rule rule, String message, WrittenRequirement item) {
      diagnostics.add(Diagnostic.of(rule, message, item.location()));
    }
  }
}

package dev.eventchain.lsp.check;

import dev.eventchain.check.EditorRules;
import dev.eventchain.diagnostics.Coverage;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.editing.TextRange;
import dev.eventchain.lsp.text.OpenText;
import dev.eventchain.lsp.text.OpenTexts;
import dev.eventchain.lsp.text.Positions;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.eclipse.lsp4j.DiagnosticCodeDescription;
import org.eclipse.lsp4j.DiagnosticRelatedInformation;
import org.eclipse.lsp4j.DiagnosticSeverity;
import org.eclipse.lsp4j.Location;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.Range;

/**
 * The findings of all units, and those that the editor shows of each file. A file is published when
 * its findings change, with none when the last one is gone. What is known of findings can be asked
 * while others are published. Thread-safe.
 */
public final class Findings {

  /** The most findings that are shown of a file. */
  static final int MOST = 1000;

  private final OpenTexts texts;
  private final RulePageFiles pages;
  private final Consumer<PublishDiagnosticsParams> publisher;

  /** Findings of the units by the files at which they are shown. */
  private final Map<CheckUnit, Map<Path, List<Diagnostic>>> units = new HashMap<>();

  /** Lock of one publication after the other, always taken before that of the findings. */
  private final Object publishing = new Object();

  private final Map<Path, Set<CheckUnit>> unitsOf = new HashMap<>();
  private final Map<Path, List<Diagnostic>> shown = new HashMap<>();

  /**
   * The addresses under which files were published: an editor may write others than we do. Used
   * while publishing.
   */
  private final Map<Path, String> addresses = new HashMap<>();

  /** Creates an empty set of findings. */
  public Findings(
      OpenTexts texts, RulePageFiles pages, Consumer<PublishDiagnosticsParams> publisher) {
    this.texts = texts;
    this.pages = pages;
    this.publisher = publisher;
  }

  /** Replaces the findings of a unit. */
  void replace(CheckUnit unit, List<Diagnostic> found) {
    Map<Path, List<Diagnostic>> now = new HashMap<>();
    for (Diagnostic each : found) {
      now.computeIfAbsent(fileOf(each, unit), key -> new ArrayList<>()).add(each);
    }
    put(unit, now).forEach(this::publish);
  }

  /** Takes over the findings of a unit, and returns the files about which it has said something. */
  private synchronized Set<Path> put(CheckUnit unit, Map<Path, List<Diagnostic>> now) {
    Map<Path, List<Diagnostic>> before = now.isEmpty() ? units.remove(unit) : units.put(unit, now);
    Set<Path> files = new TreeSet<>(now.keySet());
    if (before != null) {
      files.addAll(before.keySet());
    }
    for (Path file : files) {
      Set<CheckUnit> about = unitsOf.computeIfAbsent(file, key -> new LinkedHashSet<>());
      if (now.containsKey(file)) {
        about.add(unit);
      } else {
        about.remove(unit);
      }
      if (about.isEmpty()) {
        unitsOf.remove(file);
      }
    }
    return files;
  }

  /** Forgets a unit, with its findings. */
  void remove(CheckUnit unit) {
    replace(unit, List.of());
  }

  /** Shows the findings of a file as the editor counts and addresses its text now. */
  public void showAgain(Path file) {
    synchronized (publishing) {
      String before = addresses.get(file);
      if (before != null && !before.equals(address(file))) {
        publisher.accept(new PublishDiagnosticsParams(before, List.of()));
      }
      if (before != null) {
        publisher.accept(params(file, shown(file)));
      }
    }
  }

  private synchronized List<Diagnostic> shown(Path file) {
    return shown.getOrDefault(file, List.of());
  }

  private String address(Path file) {
    return texts.of(file).map(OpenText::uri).orElseGet(() -> file.toUri().toString());
  }

  /**
   * A finding that the editor shows.
   *
   * @param asSent as the editor has been told
   * @param project the folder of the project whose check has found it; empty if another check has
   *     found it, too, or only others
   */
  public record Shown(
      Diagnostic finding, org.eclipse.lsp4j.Diagnostic asSent, Optional<Path> project) {}

  /** Returns the findings that are shown of a file and touch a range. */
  public List<Shown> in(Path file, Range range) {
    boolean marked = texts.of(file).map(OpenText::hasMark).orElse(false);
    TextRange wanted = Positions.of(range);
    return shown(file).stream()
        .map(each -> new Shown(each, converted(each, file, marked), project(file, each)))
        .filter(
            each -> {
              TextRange place = Positions.of(each.asSent().getRange());
              return place.touches(wanted.start()) || wanted.touches(place.start());
            })
        .toList();
  }

  private synchronized Optional<Path> project(Path file, Diagnostic finding) {
    List<CheckUnit> finders =
        unitsOf.getOrDefault(file, Set.of()).stream()
            .filter(unit -> units.get(unit).get(file).contains(finding))
            .toList();
    return finders.size() == 1 && finders.get(0) instanceof ProjectUnit project
        ? Optional.of(project.folder())
        : Optional.empty();
  }

  private void publish(Path file) {
    synchronized (publishing) {
      changed(file).ifPresent(found -> publisher.accept(params(file, found)));
    }
  }

  /** Returns the present findings of a file from now on shown; empty if they are shown already. */
  private synchronized Optional<List<Diagnostic>> changed(Path file) {
    Set<Diagnostic> all = new LinkedHashSet<>();
    Set<CheckUnit> about = unitsOf.getOrDefault(file, Set.of());
    about.forEach(unit -> all.addAll(units.get(unit).get(file)));
    List<Diagnostic> found = List.copyOf(all);
    List<Diagnostic> before = found.isEmpty() ? shown.remove(file) : shown.put(file, found);
    return found.equals(before == null ? List.of() : before)
        ? Optional.empty()
        : Optional.of(found);
  }

  private PublishDiagnosticsParams params(Path file, List<Diagnostic> found) {
    Optional<OpenText> open = texts.of(file);
    String uri = address(file);
    if (found.isEmpty()) {
      addresses.remove(file);
    } else {
      addresses.put(file, uri);
    }
    boolean marked = open.map(OpenText::hasMark).orElse(false);
    List<org.eclipse.lsp4j.Diagnostic> shownOf =
        limited(file, found).stream().map(each -> converted(each, file, marked)).toList();
    PublishDiagnosticsParams params = new PublishDiagnosticsParams(uri, shownOf);
    open.ifPresent(text -> params.setVersion(text.version()));
    return params;
  }

  private static List<Diagnostic> limited(Path file, List<Diagnostic> found) {
    if (found.size() <= MOST) {
      return found;
    }
    List<Diagnostic> sorted = new ArrayList<>(found);
    sorted.sort(Comparator.comparing(Diagnostic::severity)); // errors first
    String more = Coverage.counted(found.size() - MOST, "finding");
    Diagnostic rest =
        Diagnostic.of(
                EditorRules.FINDINGS_MORE, "Not shown: " + more + " more.", SourceLocation.of(file))
            .withSeverity(sorted.get(MOST).severity())
            .withHint("'eventchain validate' on the command line shows all.");
    List<Diagnostic> first = new ArrayList<>(sorted.subList(0, MOST));
    first.add(rest);
    return first;
  }

  /** Returns the file at which a finding is shown: that of its unit if it is about no other one. */
  private Path fileOf(Diagnostic finding, CheckUnit unit) {
    return file(finding.location()).orElse(unit.subject());
  }

  private Optional<Path> file(SourceLocation place) {
    if (place.file().isEmpty()) {
      return Optional.empty();
    }
    Path file = Path.of(place.file());
    return Optional.of(file)
        .filter(Path::isAbsolute)
        .map(Path::normalize)
        .filter(each -> texts.of(each).isPresent() || Files.isRegularFile(each));
  }

  private org.eclipse.lsp4j.Diagnostic converted(Diagnostic finding, Path file, boolean marked) {
    boolean here = file(finding.location()).filter(file::equals).isPresent();
    SourceLocation place = here ? finding.location() : SourceLocation.NONE;
    org.eclipse.lsp4j.Diagnostic converted =
        new org.eclipse.lsp4j.Diagnostic(FindingRange.of(place, marked), message(finding, here));
    converted.setSeverity(
        switch (finding.severity()) {
          case ERROR -> DiagnosticSeverity.Error;
          case WARNING -> DiagnosticSeverity.Warning;
          case INFO -> DiagnosticSeverity.Information;
        });
    converted.setSource("eventchain");
    converted.setCode(finding.id());
    pages
        .of(finding.id())
        .ifPresent(
            page ->
                converted.setCodeDescription(
                    new DiagnosticCodeDescription(page.toUri().toString())));
    List<DiagnosticRelatedInformation> related =
        finding.related().stream().flatMap(each -> related(each).stream()).toList();
    if (!related.isEmpty()) {
      converted.setRelatedInformation(related);
    }
    converted.setData(data(finding));
    return converted;
  }

  private static String message(Diagnostic finding, boolean here) {
    StringBuilder text = new StringBuilder();
    if (!here && !finding.location().file().isEmpty()) {
      text.append(finding.location()).append(": ");
    }
    text.append(finding.message());
    if (!finding.rule().isEmpty()) {
      text.append(" [").append(finding.rule()).append(']');
    }
    if (!finding.hint().isEmpty()) {
      text.append('\n').append(finding.hint());
    }
    return text.toString();
  }

  private Optional<DiagnosticRelatedInformation> related(SourceLocation place) {
    return file(place)
        .map(
            file -> {
              boolean marked = texts.of(file).map(OpenText::hasMark).orElse(false);
              Location location =
                  new Location(file.toUri().toString(), FindingRange.of(place, marked));
              String text = place.element().isEmpty() ? "see here" : place.element();
              return new DiagnosticRelatedInformation(location, text);
            });
  }

  /** Returns the parts of a finding that its text has put together, for programs. */
  private static Map<String, String> data(Diagnostic finding) {
    Map<String, String> data = new LinkedHashMap<>();
    data.put("message", finding.message());
    data.put("hint", finding.hint());
    data.put("rule", finding.rule());
    data.put("element", finding.location().element());
    return data;
  }
}

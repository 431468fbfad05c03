package dev.eventchain.eclipse;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import java.net.URI;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.Collectors;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.resources.IResource;
import org.eclipse.core.resources.ResourcesPlugin;

/**
 * The marker of a finding: on its file, with line and character range, or on the checked resource
 * if the finding concerns no file of the workspace.
 *
 * @param resource the resource of the marker
 * @param attributes those of {@link IMarker}, and the ones named here, as texts
 */
public record FindingMarker(IResource resource, Map<String, Object> attributes) {

  /** Identifier of the finding. */
  public static final String ID = "id";

  /** User's rule that the finding is about; empty if there is none. */
  public static final String RULE = "rule";

  /** The path of the model element, or the JSON pointer; empty if there is none. */
  public static final String ELEMENT = "element";

  /** The hint of the finding; empty if there is none. */
  public static final String HINT = "hint";

  /** Related locations, one per line. */
  public static final String RELATED = "related";

  /** The column, from 1; 0 if unknown. */
  public static final String COLUMN = "column";

  /** Largest length of a text: the platform rejects texts of more than 65,535 bytes. */
  private static final int MOST_CHARACTERS = 16_000;

  /**
   * Returns the marker of a finding.
   *
   * @param subject the resource that was checked
   * @param texts the texts of the files, read once
   */
  static FindingMarker of(Diagnostic finding, IResource subject, MarkerTexts texts) {
    SourceLocation place = finding.location();
    IResource file = fileOf(place, subject);
    boolean elsewhere = file == null;
    Map<String, Object> attributes = new HashMap<>();
    attributes.put(IMarker.SEVERITY, severity(finding));
    attributes.put(IMarker.MESSAGE, cut(message(finding, elsewhere)));
    attributes.put(IMarker.SOURCE_ID, EventchainCore.ID);
    attributes.put(ID, finding.id());
    attributes.put(RULE, cut(finding.rule()));
    attributes.put(HINT, cut(finding.hint()));
    attributes.put(ELEMENT, cut(place.element()));
    attributes.put(RELATED, cut(related(finding)));
    attributes.put(COLUMN, place.column());
    if (!place.element().isEmpty()) {
      attributes.put(IMarker.LOCATION, cut(location(place)));
    }
    if (!elsewhere && place.line() > 0) {
      attributes.put(IMarker.LINE_NUMBER, place.line());
      texts.addRange(file, place, attributes);
    }
    return new FindingMarker(elsewhere ? subject : file, attributes);
  }

  private static String location(SourceLocation place) {
    return place.line() > 0 ? "line " + place.line() + ", " + place.element() : place.element();
  }

  private static int severity(Diagnostic finding) {
    return switch (finding.severity()) {
      case ERROR -> IMarker.SEVERITY_ERROR;
      case WARNING -> IMarker.SEVERITY_WARNING;
      case INFO -> IMarker.SEVERITY_INFO;
    };
  }

  private static String message(Diagnostic finding, boolean elsewhere) {
    String place = finding.location().toString();
    String before = elsewhere && !place.isEmpty() ? place + ": " : "";
    String hint = finding.hint().isEmpty() ? "" : " " + finding.hint();
    return before + finding.message() + hint;
  }

  private static String related(Diagnostic finding) {
    return finding.related().stream()
        .map(SourceLocation::toString)
        .collect(Collectors.joining("\n"));
  }

  private static String cut(String text) {
    return text.length() <= MOST_CHARACTERS ? text : text.substring(0, MOST_CHARACTERS) + " ...";
  }

  /**
   * Returns the file in the checked project: others get their markers from their own builds only.
   */
  private static IResource fileOf(SourceLocation place, IResource subject) {
    if (place.file().isEmpty()) {
      return null;
    }
    Path path = Path.of(place.file());
    if (!path.isAbsolute()) {
      return null; // a document that ships with the program: those of the workspace have full paths
    }
    URI uri = path.toUri();
    IFile[] found = ResourcesPlugin.getWorkspace().getRoot().findFilesForLocationURI(uri);
    for (IFile each : found) {
      if (each.exists() && each.getProject().equals(subject.getProject())) {
        return each;
      }
    }
    return null;
  }
}

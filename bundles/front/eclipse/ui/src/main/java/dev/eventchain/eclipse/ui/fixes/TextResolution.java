package dev.eventchain.eclipse.ui.fixes;

import dev.eventchain.diagnostics.TextFix;
import dev.eventchain.eclipse.FindingMarker;
import java.util.Optional;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.ui.IMarkerResolution;

/** Fixes a finding by a change of the file's text. */
final class TextResolution implements IMarkerResolution {

  /** A change of the text. */
  @FunctionalInterface
  private interface Change {
    Optional<TextFix> of(String text, int offset, IMarker marker);
  }

  private final String label;
  private final Change change;

  private TextResolution(String label, Change change) {
    this.label = label;
    this.change = change;
  }

  /** Returns a fix that inserts the proposed name. */
  static TextResolution nearestName(String name) {
    return new TextResolution(
        "Change to '" + name + "'",
        (text, offset, marker) ->
            TextFix.nearestName(
                text,
                offset,
                String.valueOf(marker.getResource().getFileExtension()),
                marker.getAttribute(IMarker.MESSAGE, ""),
                marker.getAttribute(FindingMarker.HINT, "")));
  }

  /** Returns a fix that removes a dangling reference. */
  static TextResolution withoutReference() {
    return new TextResolution(
        "Remove the reference",
        (text, offset, marker) ->
            TextFix.withoutReference(text, offset, marker.getAttribute(IMarker.MESSAGE, "")));
  }

  @Override
  public String getLabel() {
    return label;
  }

  @Override
  public void run(IMarker marker) {
    FileEdit.start(
        label,
        (IFile) marker.getResource(),
        text -> {
          int offset = marker.getAttribute(IMarker.CHAR_START, -1);
          return change.of(text, offset, marker).map(fix -> fix.apply(text));
        });
  }
}

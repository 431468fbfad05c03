package dev.eventchain.eclipse.ui.text;

import dev.eventchain.eclipse.FindingMarker;
import java.util.Iterator;
import java.util.LinkedHashSet;
import java.util.Set;
import org.eclipse.core.resources.IMarker;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.IRegion;
import org.eclipse.jface.text.ITextHover;
import org.eclipse.jface.text.ITextViewer;
import org.eclipse.jface.text.Position;
import org.eclipse.jface.text.Region;
import org.eclipse.jface.text.source.Annotation;
import org.eclipse.jface.text.source.IAnnotationHover;
import org.eclipse.jface.text.source.IAnnotationModel;
import org.eclipse.jface.text.source.ISourceViewer;
import org.eclipse.ui.texteditor.MarkerAnnotation;

/** Shows the findings under the mouse: message, rule and related elements. */
final class ProblemHover implements ITextHover, IAnnotationHover {

  private final ISourceViewer viewer;

  ProblemHover(ISourceViewer viewer) {
    this.viewer = viewer;
  }

  @Override
  public String getHoverInfo(ITextViewer text, IRegion region) {
    return texts(region.getOffset(), region.getLength());
  }

  @Override
  public IRegion getHoverRegion(ITextViewer text, int offset) {
    return new Region(offset, 0);
  }

  @Override
  public String getHoverInfo(ISourceViewer source, int line) {
    IDocument document = viewer.getDocument();
    try {
      return texts(document.getLineOffset(line), document.getLineLength(line) - 1);
    } catch (BadLocationException e) {
      return null; // the line is gone
    }
  }

  /** Returns the findings that touch a region; null if there are none, as the platform requires. */
  private String texts(int offset, int length) {
    Set<String> texts = new LinkedHashSet<>();
    IAnnotationModel model = viewer.getAnnotationModel();
    if (model != null) {
      for (Iterator<Annotation> all = model.getAnnotationIterator(); all.hasNext(); ) {
        Annotation each = all.next();
        Position place = model.getPosition(each);
        boolean touched =
            place != null
                && place.getOffset() <= offset + Math.max(0, length)
                && offset <= place.getOffset() + place.getLength();
        if (touched && each.getText() != null && !each.isMarkedDeleted()) {
          texts.add(text(each));
        }
      }
    }
    return texts.isEmpty() ? null : String.join("\n\n", texts);
  }

  private static String text(Annotation annotation) {
    if (!(annotation instanceof MarkerAnnotation of)) {
      return annotation.getText();
    }
    IMarker marker = of.getMarker();
    String rule = marker.getAttribute(FindingMarker.RULE, "");
    String id = marker.getAttribute(FindingMarker.ID, "");
    String related = marker.getAttribute(FindingMarker.RELATED, "");
    return annotation.getText()
        + (id.isEmpty() ? "" : "\n[" + id + "]")
        + (rule.isEmpty() ? "" : "\nRule: " + rule)
        + (related.isEmpty() ? "" : "\nSee also: " + related.replace("\n", "\n  "));
  }
}

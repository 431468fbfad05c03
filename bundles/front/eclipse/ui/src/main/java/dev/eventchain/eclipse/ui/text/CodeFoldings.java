package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.Folding;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.IDocument;
import org.eclipse.jface.text.Position;
import org.eclipse.jface.text.source.Annotation;
import org.eclipse.jface.text.source.projection.ProjectionAnnotation;
import org.eclipse.jface.text.source.projection.ProjectionAnnotationModel;

/** The lines that can be folded; those that stay keep their state. */
final class CodeFoldings {

  private CodeFoldings() {}

  static void show(List<Folding> foldings, IDocument document, ProjectionAnnotationModel model) {
    Set<Position> wanted = new HashSet<>();
    for (Folding each : foldings) {
      try {
        int start = document.getLineOffset(each.firstLine());
        int end = document.getLineOffset(each.lastLine()) + document.getLineLength(each.lastLine());
        wanted.add(new Position(start, end - start));
      } catch (BadLocationException e) {
        continue; // the text has become shorter, and is analysed again
      }
    }
    List<Annotation> gone = new ArrayList<>();
    for (Iterator<Annotation> all = model.getAnnotationIterator(); all.hasNext(); ) {
      Annotation each = all.next();
      if (!wanted.remove(model.getPosition(each))) {
        gone.add(each);
      }
    }
    Map<Annotation, Position> added = new HashMap<>();
    wanted.forEach(each -> added.put(new ProjectionAnnotation(), each));
    if (!gone.isEmpty() || !added.isEmpty()) {
      model.modifyAnnotations(gone.toArray(Annotation[]::new), added, null);
    }
  }
}

package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.Analysis;
import dev.eventchain.editing.Hover;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.eclipse.jface.text.IRegion;
import org.eclipse.jface.text.ITextHover;
import org.eclipse.jface.text.ITextHoverExtension2;
import org.eclipse.jface.text.ITextViewer;

/** Shows the findings about the word under the mouse, and what the analysis says about it. */
final class CodeHover implements ITextHover, ITextHoverExtension2 {

  private final CodeEditor editor;
  private final ProblemHover problems;

  CodeHover(CodeEditor editor, ProblemHover problems) {
    this.editor = editor;
    this.problems = problems;
  }

  /** Returns a text in Markdown as people read it. */
  static String plain(String markdown) {
    return markdown
        .lines()
        .filter(line -> !line.startsWith("```"))
        .map(line -> line.replaceAll("\\*\\*|`", ""))
        .collect(Collectors.joining("\n"))
        .strip();
  }

  @Override
  public String getHoverInfo(ITextViewer viewer, IRegion region) {
    return getHoverInfo2(viewer, region);
  }

  /** Called in the background. */
  @Override
  public String getHoverInfo2(ITextViewer viewer, IRegion region) {
    String found = problems.getHoverInfo(viewer, region);
    CodeText text = editor.text();
    String about =
        text == null
            ? ""
            : text.ask(region.getOffset(), Analysis::hover)
                .join()
                .flatMap(each -> each)
                .map(Hover::markdown)
                .map(CodeHover::plain)
                .orElse("");
    String all =
        Stream.of(Optional.ofNullable(found).orElse(""), about)
            .filter(each -> !each.isEmpty())
            .collect(Collectors.joining("\n\n"));
    return all.isEmpty() ? null : all; // null for nothing, as the platform requires
  }

  @Override
  public IRegion getHoverRegion(ITextViewer viewer, int offset) {
    return CodeEditor.word(viewer.getDocument(), offset);
  }
}

package dev.eventchain.eclipse.ui.text;

import dev.eventchain.editing.SemanticToken;
import dev.eventchain.editing.TextLines;
import dev.eventchain.editing.TextPosition;
import dev.eventchain.m2t.TemplateParts;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.eclipse.jface.resource.ColorRegistry;
import org.eclipse.jface.text.Region;
import org.eclipse.jface.text.TextPresentation;
import org.eclipse.jface.util.IPropertyChangeListener;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StyleRange;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.themes.IThemeManager;

/** Colours of words, defined by the theme so that people can change them. */
final class CodeColors {

  /** A part of a text that has a colour. */
  record Colored(TokenKind kind, int start, int end) {}

  private CodeColors() {}

  private static IThemeManager themes() {
    return PlatformUI.getWorkbench().getThemeManager();
  }

  /** Returns the parts of a text that have a colour, in the order of the text. */
  static List<Colored> of(
      Language language, String text, TextLines lines, List<SemanticToken> tokens) {
    List<Colored> found = new ArrayList<>();
    for (SemanticToken token : tokens) {
      kind(token.kind())
          .ifPresent(
              kind -> {
                int start = lines.offset(new TextPosition(token.line(), token.column()));
                found.add(new Colored(kind, start, start + token.length()));
              });
    }
    if (language == Language.TEMPLATE) {
      TemplateParts.of(text).stream()
          .filter(part -> part.kind() == TemplateParts.Kind.TAG)
          .forEach(part -> addBrackets(text, part, found));
    }
    found.sort(Comparator.comparingInt(Colored::start));
    return found;
  }

  private static void addBrackets(String text, TemplateParts.Part tag, List<Colored> found) {
    int last = tag.end() - 1;
    boolean closing = text.startsWith("/", tag.start() + 1);
    found.add(new Colored(TokenKind.TAG, tag.start(), tag.start() + (closing ? 2 : 1)));
    boolean single = !closing && last > tag.start() && text.charAt(last - 1) == '/';
    found.add(new Colored(TokenKind.TAG, single ? last - 1 : last, tag.end()));
  }

  private static Optional<TokenKind> kind(SemanticToken.Kind kind) {
    return switch (kind) {
      case KEYWORD -> Optional.of(TokenKind.KEYWORD);
      case TYPE -> Optional.of(TokenKind.TYPE);
      case STRING -> Optional.of(TokenKind.STRING);
      case NUMBER, ENUMERATION_LITERAL -> Optional.of(TokenKind.NUMBER);
      case COMMENT -> Optional.of(TokenKind.COMMENT);
      default -> Optional.empty();
    };
  }

  /** Returns how a text of a length is drawn; what has no colour gets that of the editor. */
  static TextPresentation presentation(List<Colored> parts, int length) {
    ColorRegistry colors = themes().getCurrentTheme().getColorRegistry();
    TextPresentation presentation = new TextPresentation(new Region(0, length), parts.size() + 1);
    presentation.setDefaultStyleRange(new StyleRange(0, length, null, null));
    int end = 0;
    for (Colored part : parts) {
      if (part.start() >= end && part.end() <= length) {
        boolean bold = part.kind() == TokenKind.KEYWORD || part.kind() == TokenKind.TAG;
        presentation.addStyleRange(
            new StyleRange(
                part.start(),
                part.end() - part.start(),
                colors.get(part.kind().color()),
                null,
                bold ? SWT.BOLD : SWT.NORMAL));
        end = part.end();
      }
    }
    return presentation;
  }

  /** Adds a listener for changes of a theme, including other colours. */
  static void listen(IPropertyChangeListener listener) {
    themes().addPropertyChangeListener(listener);
  }

  static void forget(IPropertyChangeListener listener) {
    themes().removePropertyChangeListener(listener);
  }
}

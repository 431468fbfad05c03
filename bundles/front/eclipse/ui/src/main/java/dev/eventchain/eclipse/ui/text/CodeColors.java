package dev.eventchain.eclipse.ui.text;

import org.eclipse.jface.resource.ColorRegistry;
import org.eclipse.jface.text.TextAttribute;
import org.eclipse.jface.util.IPropertyChangeListener;
import org.eclipse.swt.SWT;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.themes.IThemeManager;

/** Colours of tokens, defined by the theme so that people can change them. */
final class CodeColors {

  private CodeColors() {}

  private static IThemeManager themes() {
    return PlatformUI.getWorkbench().getThemeManager();
  }

  /** Returns the current style of a token; text and plain code have the editor's default style. */
  static TextAttribute attribute(TokenKind kind) {
    if (kind == TokenKind.TEXT || kind == TokenKind.CODE) {
      return new TextAttribute(null);
    }
    ColorRegistry colors = themes().getCurrentTheme().getColorRegistry();
    boolean bold = kind == TokenKind.KEYWORD || kind == TokenKind.TAG;
    return new TextAttribute(colors.get(kind.color()), null, bold ? SWT.BOLD : SWT.NORMAL);
  }

  /** Adds a listener for changes of a theme, including other colours. */
  static void listen(IPropertyChangeListener listener) {
    themes().addPropertyChangeListener(listener);
  }

  static void forget(IPropertyChangeListener listener) {
    themes().removePropertyChangeListener(listener);
  }
}

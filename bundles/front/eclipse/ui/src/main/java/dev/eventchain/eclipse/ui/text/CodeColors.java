package dev.eventchain.eclipse.ui.text;

import org.eclipse.jface.resource.ColorRegistry;
import org.eclipse.jface.text.TextAttribute;
import org.eclipse.jface.util.IPropertyChangeListener;
import org.eclipse.swt.SWT;
import org.eclipse.ui.PlatformUI;
import org.eclipse.ui.themes.IThemeManager;

/** The colours of tokens, which are definitions of the theme: people may change them. */
final class CodeColors {

  private CodeColors() {}

  private static IThemeManager themes() {
    return PlatformUI.getWorkbench().getThemeManager();
  }

  /** How a token is drawn now; text and plain code as the editor draws any text. */
  static TextAttribute attribute(TokenKind kind) {
    if (kind == TokenKind.TEXT || kind == TokenKind.CODE) {
      return new TextAttribute(null);
    }
    ColorRegistry colors = themes().getCurrentTheme().getColorRegistry();
    boolean bold = kind == TokenKind.KEYWORD || kind == TokenKind.TAG;
    return new TextAttribute(colors.get(kind.color()), null, bold ? SWT.BOLD : SWT.NORMAL);
  }

  /** Tells of each change of a theme, of ours or another's colour. */
  static void listen(IPropertyChangeListener listener) {
    themes().addPropertyChangeListener(listener);
  }

  static void forget(IPropertyChangeListener listener) {
    themes().removePropertyChangeListener(listener);
  }
}

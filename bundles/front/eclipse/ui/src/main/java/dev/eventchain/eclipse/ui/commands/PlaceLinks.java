package dev.eventchain.eclipse.ui.commands;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.ui.console.IPatternMatchListener;
import org.eclipse.ui.console.PatternMatchEvent;
import org.eclipse.ui.console.TextConsole;

/** Turns {@code /a/file:12:3} in a console into a link that opens the file at the line. */
final class PlaceLinks implements IPatternMatchListener {

  private static final Pattern PLACE = Pattern.compile("(/[^\\s:]+)(?::(\\d+))?(?::\\d+)?");

  private TextConsole console;

  @Override
  public void connect(TextConsole to) {
    console = to;
  }

  @Override
  public void disconnect() {
    console = null;
  }

  @Override
  public void matchFound(PatternMatchEvent event) {
    try {
      String text = console.getDocument().get(event.getOffset(), event.getLength());
      Matcher place = PLACE.matcher(text);
      if (!place.matches()) {
        return;
      }
      int line = place.group(2) == null ? 0 : Integer.parseInt(place.group(2));
      IFile[] files =
          ResourcesPlugin.getWorkspace()
              .getRoot()
              .findFilesForLocationURI(Path.of(place.group(1)).toUri());
      if (files.length > 0 && files[0].exists()) {
        console.addHyperlink(new PlaceLink(files[0], line), event.getOffset(), event.getLength());
      }
    } catch (BadLocationException | InvalidPathException | NumberFormatException e) {
      return; // the text is gone meanwhile, or is no location
    }
  }

  @Override
  public String getPattern() {
    return PLACE.pattern();
  }

  @Override
  public int getCompilerFlags() {
    return 0;
  }

  @Override
  public String getLineQualifier() {
    return "/";
  }
}

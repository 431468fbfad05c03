package dev.eventchain.eclipse.ui.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.jface.text.BadLocationException;
import org.eclipse.jface.text.ITextViewer;
import org.eclipse.jface.text.Position;
import org.eclipse.jface.text.link.LinkedModeModel;
import org.eclipse.jface.text.link.LinkedModeUI;
import org.eclipse.jface.text.link.LinkedPosition;
import org.eclipse.jface.text.link.LinkedPositionGroup;
import org.eclipse.ui.texteditor.link.EditorLinkedModeUI;

/**
 * A text with places to fill in, one after the other with the tabulator.
 *
 * @param places the places of each number, by numbers
 * @param exit the offset at which people go on
 */
record Snippet(String text, Map<Integer, List<Position>> places, int exit) {

  /** An escaped character, or a place: {@code $1}, <code>${1}</code>, <code>${1:name}</code>. */
  private static final Pattern SYNTAX =
      Pattern.compile("\\\\([$}\\\\])|\\$(\\d+)|\\$\\{(\\d+)(?::((?:[^}\\\\]|\\\\.)*))?}");

  /** Returns a text without places. */
  static Snippet plain(String text) {
    return new Snippet(text, Map.of(), text.length());
  }

  /** Reads the syntax of the Language Server Protocol. */
  static Snippet of(String source) {
    StringBuilder text = new StringBuilder();
    Map<Integer, List<Position>> places = new TreeMap<>();
    int exit = -1;
    Matcher found = SYNTAX.matcher(source);
    while (found.find()) {
      found.appendReplacement(text, "");
      if (found.group(1) != null) {
        text.append(found.group(1));
        continue;
      }
      int number = Integer.parseInt(found.group(2) != null ? found.group(2) : found.group(3));
      String name = found.group(4) == null ? "" : found.group(4).replaceAll("\\\\(.)", "$1");
      if (number == 0) {
        exit = text.length();
      } else {
        Position place = new Position(text.length(), name.length());
        places.computeIfAbsent(number, each -> new ArrayList<>()).add(place);
      }
      text.append(name);
    }
    found.appendTail(text);
    return new Snippet(text.toString(), places, exit < 0 ? text.length() : exit);
  }

  /** Selects the first place in a viewer that has the text at an offset. */
  void fillIn(ITextViewer viewer, int offset) {
    if (places.isEmpty()) {
      viewer.setSelectedRange(offset + exit, 0);
      return;
    }
    try {
      LinkedModeModel model = new LinkedModeModel();
      for (List<Position> each : places.values()) {
        LinkedPositionGroup group = new LinkedPositionGroup();
        for (Position place : each) {
          int start = offset + place.getOffset();
          group.addPosition(new LinkedPosition(viewer.getDocument(), start, place.getLength()));
        }
        model.addGroup(group);
      }
      model.forceInstall();
      LinkedModeUI selection = new EditorLinkedModeUI(model, viewer);
      selection.setExitPosition(viewer, offset + exit, 0, Integer.MAX_VALUE);
      selection.enter();
      Position first = places.values().iterator().next().get(0);
      viewer.setSelectedRange(offset + first.getOffset(), first.getLength());
    } catch (BadLocationException e) {
      viewer.setSelectedRange(offset + exit, 0); // places over each other: filled in by hand
    }
  }
}

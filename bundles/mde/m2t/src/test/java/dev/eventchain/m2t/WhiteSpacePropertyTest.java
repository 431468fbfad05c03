package dev.eventchain.m2t;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Properties of the white space of any body, independent of the rules. */
class WhiteSpacePropertyTest {
  /** A part of a body, and its text if tags take no white space. */
  private record Piece(String source, String plain) {
    static Piece text(String text) {
      return new Piece(text, text);
    }
  }

  private static final List<Piece> PIECES =
      List.of(
          Piece.text("x"),
          Piece.text("\n"),
          Piece.text("  "),
          Piece.text("\t"),
          new Piece("[l.name/]", "City"),
          new Piece("[comment c/]", ""),
          new Piece("[comment]\nc\n[/comment]", ""),
          new Piece("[if (true)][/if]", ""),
          new Piece("[if (true)]x[else]y[/if]", "x"),
          new Piece("[if (true)] [/if]", " "),
          new Piece("[if (true)]\nx\n[/if]", "\nx\n"),
          new Piece("  [if (false)]\nx\n  [else]\n  y[comment c/]\n  [/if]", "  \n  y\n  "),
          new Piece("[for (i : Integer | Sequence{1, 2})][i/] [/for]", "1 2 "),
          new Piece("[for (i : Integer | Sequence{1, 2})]\n  [i/]\n[/for]", "\n  1\n\n  2\n"),
          new Piece("[let v : String = 'v'][v/][/let]", "v"),
          new Piece("[let v : String = 'v']\n\t[v/]  [/let]", "\n\tv  "),
          new Piece("[l.one()/]", "one"),
          new Piece("['a'.concat('b')/]", "ab"),
          new Piece(
              "[protected ('@')]\nz\n[/protected]", "Start of user code @\nz\nEnd of user code"));

  private static Stream<List<Piece>> bodies() {
    Random random = new Random(16);
    return IntStream.range(0, 400)
        .mapToObj(
            body -> {
              List<Piece> pieces = new ArrayList<>();
              for (int i = 0; i <= body % 8; i++) {
                Piece piece = PIECES.get(random.nextInt(PIECES.size()));
                String area = "area" + i;
                pieces.add(
                    new Piece(piece.source().replace("@", area), piece.plain().replace("@", area)));
              }
              return pieces;
            });
  }

  @ParameterizedTest
  @MethodSource("bodies")
  void nothingButWhiteSpaceGoes(List<Piece> body) {
    StringBuilder plain = new StringBuilder("\n");
    body.forEach(piece -> plain.append(piece.plain()));
    String written = WhiteSpaceBodies.file(source(body));
    int read = 0;
    for (int i = 0; i < plain.length(); i++) {
      boolean same = read < written.length() && written.charAt(read) == plain.charAt(i);
      assertTrue(
          same || Character.isWhitespace(plain.charAt(i)), () -> plain + " became " + written);
      read += same ? 1 : 0;
    }
    assertEquals(written.length(), read, () -> plain + " became " + written);
  }

  @ParameterizedTest
  @MethodSource("bodies")
  void anyLineBreakIsTreatedTheSame(List<Piece> body) {
    String wide = WhiteSpaceBodies.file(source(body).replace("\n", "\r\n"));
    assertEquals(WhiteSpaceBodies.file(source(body)), wide.replace("\r\n", "\n"));
    String called = WhiteSpaceBodies.called(source(body).replace("\n", "\r\n"));
    assertEquals(WhiteSpaceBodies.called(source(body)), called.replace("\r\n", "\n"));
  }

  @ParameterizedTest
  @MethodSource("bodies")
  void callsAreIndentedLineByLine(List<Piece> body) {
    String called = WhiteSpaceBodies.called(source(body));
    String indented =
        WhiteSpaceBodies.file("\n  <[l.t()/]>", "[template public t(l : Library)]" + source(body));
    assertEquals("  " + called.replace("\n", "\n  "), indented);
  }

  private static String source(List<Piece> body) {
    StringBuilder source = new StringBuilder("\n");
    body.forEach(piece -> source.append(piece.source()));
    return source.toString();
  }
}

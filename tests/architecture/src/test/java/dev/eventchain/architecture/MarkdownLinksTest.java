package dev.eventchain.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the links of the project's Markdown lead to existing files and headings. */
class MarkdownLinksTest {

  @TempDir Path folder;

  @Test
  void everyLinkLeadsSomewhere() throws IOException {
    MarkdownLinks links = new MarkdownLinks(MarkdownFiles.ROOT);

    assertEquals(List.of(), links.broken());
    assertTrue(links.count() > 60, links.count() + " links");
  }

  @Test
  void whatLeadsNowhereIsFound() throws IOException {
    write("a.md", "# A & `b`: c\n## Twice\n## Twice\n[x](sub/b.md#one-two) [y](#twice-1) [z](sub)");
    write("sub/b.md", "# One two\n[a](../a.md#a--b-c), [far](https://example.org/none.md)\n");
    write("target/c.md", "[made](none.md)");
    assertEquals(List.of(), new MarkdownLinks(folder).broken());
    assertEquals(4, new MarkdownLinks(folder).count());

    write(
        "sub/d.md",
        """
        [file](none.md) [anchor](b.md#two) ![picture](none.png) <img src="gone.svg">
        [own](#nothing) [outside](../../a.md) [root](/a.md) [folder](../a.md#twice-2)

            [code](is-none.md)

        | [cell](cell.md) |
        |---|
        """);
    assertEquals(
        List.of(
            "sub/d.md: none.md",
            "sub/d.md: b.md#two",
            "sub/d.md: none.png",
            "sub/d.md: gone.svg",
            "sub/d.md: #nothing",
            "sub/d.md: ../../a.md",
            "sub/d.md: /a.md",
            "sub/d.md: ../a.md#twice-2",
            "sub/d.md: cell.md"),
        new MarkdownLinks(folder).broken());
  }

  @Test
  void thePagesThatTheSiteMakesAreLinkedByItsPagesOnly() throws IOException {
    write("bundles/documentation/src/site/index.md", "[a](commands.md#run) [b](none.md)");
    write("bundles/documentation/src/site/java.md", "[a](apidocs/A.html#a()) [b](a.html)");
    write("README.md", "[a](commands.md#run)");

    assertEquals(
        List.of(
            "README.md: commands.md#run",
            "bundles/documentation/src/site/index.md: none.md",
            "bundles/documentation/src/site/java.md: a.html"),
        new MarkdownLinks(folder).broken());
  }

  private void write(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }
}

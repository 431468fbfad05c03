package dev.eventchain.architecture;

import java.io.IOException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.Code;
import org.commonmark.node.Heading;
import org.commonmark.node.HtmlBlock;
import org.commonmark.node.HtmlInline;
import org.commonmark.node.Image;
import org.commonmark.node.Link;
import org.commonmark.node.Node;
import org.commonmark.node.Text;

/**
 * Checks the links of Markdown within a folder: to files, and to headings with GitHub's anchors.
 */
final class MarkdownLinks {

  private static final Pattern HTML = Pattern.compile("\\b(?:src|href)=\"([^\"]*)\"");
  private static final Pattern ELSEWHERE = Pattern.compile("[a-z][a-z+.-]*:.*");

  /**
   * Parts of the site outside this folder: {@code SiteBuilderTest} checks them, {@code SiteTest}
   * the Javadoc.
   */
  private static final Pattern MADE_BY_THE_SITE =
      Pattern.compile(
          "(?:(?:acceleo|operations|commands|rules|rules/[\\w.-]+)\\.md|apidocs/.+\\.html)(?:#.*)?");

  private static final Path SITE = Path.of("bundles", "documentation", "src", "site");

  private final Path root;
  private final Map<Path, Set<String>> anchors = new TreeMap<>();
  private final List<String> broken = new ArrayList<>();
  private int count;

  /**
   * Checks all links.
   *
   * @param root the root folder of all link targets
   */
  MarkdownLinks(Path root) throws IOException {
    this.root = root;
    Map<Path, Node> files = MarkdownFiles.in(root);
    files.forEach((file, document) -> anchors.put(file, anchorsOf(document)));
    files.forEach((file, document) -> linksOf(document).forEach(link -> follow(file, link)));
  }

  /** Returns each broken link, as {@code file: link}. */
  List<String> broken() {
    return broken;
  }

  /** Returns the number of links, without those to other places on the network. */
  int count() {
    return count;
  }

  private void follow(Path file, String link) {
    if (ELSEWHERE.matcher(link).matches()) {
      return;
    }
    count++;
    if (SITE.equals(file.getParent()) && MADE_BY_THE_SITE.matcher(link).matches()) {
      return;
    }
    int hash = link.indexOf('#');
    String name =
        URLDecoder.decode(hash < 0 ? link : link.substring(0, hash), StandardCharsets.UTF_8);
    Path target = name.isEmpty() ? file : file.resolveSibling(name).normalize();
    boolean isThere =
        !name.startsWith("/") && !target.startsWith("..") && Files.exists(root.resolve(target));
    boolean isMeant =
        hash < 0 || anchors.getOrDefault(target, Set.of()).contains(link.substring(hash + 1));
    if (!isThere || !isMeant) {
      broken.add(file + ": " + link);
    }
  }

  private static List<String> linksOf(Node document) {
    List<String> links = new ArrayList<>();
    document.accept(
        new AbstractVisitor() {
          @Override
          public void visit(Link link) {
            links.add(link.getDestination());
            visitChildren(link);
          }

          @Override
          public void visit(Image image) {
            links.add(image.getDestination());
            visitChildren(image);
          }

          @Override
          public void visit(HtmlInline html) {
            addAll(html.getLiteral());
          }

          @Override
          public void visit(HtmlBlock html) {
            addAll(html.getLiteral());
          }

          private void addAll(String html) {
            Matcher matcher = HTML.matcher(html);
            while (matcher.find()) {
              links.add(matcher.group(1));
            }
          }
        });
    return links;
  }

  private static Set<String> anchorsOf(Node document) {
    Set<String> anchors = new HashSet<>();
    document.accept(
        new AbstractVisitor() {
          @Override
          public void visit(Heading heading) {
            String anchor = anchorOf(textOf(heading));
            String unique = anchor;
            for (int i = 1; !anchors.add(unique); i++) {
              unique = anchor + "-" + i;
            }
          }
        });
    return anchors;
  }

  /**
   * Returns the anchor of a heading: GitHub keeps letters, digits, hyphens and underscores, and
   * replaces blanks by hyphens.
   */
  private static String anchorOf(String heading) {
    String kept =
        heading.strip().toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{M}\\p{N}_\\- ]", "");
    return kept.replace(' ', '-');
  }

  private static String textOf(Node heading) {
    StringBuilder text = new StringBuilder();
    heading.accept(
        new AbstractVisitor() {
          @Override
          public void visit(Text part) {
            text.append(part.getLiteral());
          }

          @Override
          public void visit(Code part) {
            text.append(part.getLiteral());
          }
        });
    return text.toString();
  }
}

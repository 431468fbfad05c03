package dev.eventchain.xmi;

import dev.eventchain.uml.Uml;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcorePackage;
import org.eclipse.emf.ecore.xml.namespace.XMLNamespacePackage;
import org.eclipse.emf.ecore.xml.type.XMLTypePackage;

/** Decides which references between files are followed: only those within the project's folders. */
final class ProjectFiles {

  /**
   * The URIs of the standard metamodels in Eclipse and relative to other metamodels of its
   * plug-ins, such as {@code GenModel.ecore}.
   */
  private static final Pattern IN_ECLIPSE =
      Pattern.compile(
          "(?:platform:/(?:plugin|resource)/|(?:\\.\\./)+)"
              + "org\\.eclipse\\.emf\\.ecore/model/(\\w+)\\.ecore");

  private static final Map<String, String> NAMESPACES =
      Map.of(
          "Ecore", EcorePackage.eNS_URI,
          "XMLType", XMLTypePackage.eNS_URI,
          "XMLNamespace", XMLNamespacePackage.eNS_URI);

  private final List<Root> roots = new ArrayList<>();
  private final MappedUris map;
  private final EPackage.Registry registry;

  /** Accepted files of references, cached since the file system is slow. */
  private final Set<URI> followed = new HashSet<>();

  /** A folder as named by the user, and its real path. */
  private record Root(Path path, Path real) {}

  ProjectFiles(Collection<Path> roots, MappedUris map, EPackage.Registry registry) {
    this.map = map;
    roots.forEach(root -> this.roots.add(new Root(root, realPath(root))));
    this.registry = registry;
  }

  /** Returns the name of a project file in findings. */
  String nameOf(Path file) {
    Path real = realPath(file);
    Path shown =
        roots.stream()
            .filter(root -> real.startsWith(root.real))
            .findFirst()
            .map(root -> root.path.resolve(root.real.relativize(real)))
            .orElse(file);
    return shown.normalize().toString().replace('\\', '/');
  }

  /** Returns a reference with a mapped prefix as one to a file or a metamodel. */
  String mapped(URI base, String reference) {
    String known = Uml.withKnownLibrary(reference);
    if (!known.equals(reference)) {
      return known;
    }
    int hash = reference.indexOf('#');
    String target = hash < 0 ? reference : reference.substring(0, hash);
    String fragment = hash < 0 ? "" : reference.substring(hash);
    Matcher standard = IN_ECLIPSE.matcher(target);
    if (standard.matches() && NAMESPACES.containsKey(standard.group(1))) {
      return NAMESPACES.get(standard.group(1)) + fragment;
    }
    if (target.isEmpty() || registry.containsKey(target) || !base.isFile()) {
      return reference;
    }
    Optional<MappedUris.Target> found = map.fileOf(Path.of(base.toFileString()), target);
    found.flatMap(MappedUris.Target::project).ifPresent(project -> open(project, base));
    return found
        .map(each -> URI.createFileURI(each.file().toString()) + fragment)
        .orElse(reference);
  }

  /** Allows references into a project, whose name is relative if that of the file is. */
  private void open(Path project, URI base) {
    Path real = realPath(project);
    if (roots.stream().anyMatch(root -> real.startsWith(root.real))) {
      return;
    }
    Path from = realPath(Path.of(base.toFileString()));
    Path shown =
        roots.stream()
            .filter(root -> from.startsWith(root.real))
            .findFirst()
            .map(root -> root.path.resolve(root.real.relativize(real)).normalize())
            .orElse(project);
    roots.add(new Root(shown, real));
  }

  /**
   * Returns the reason why a reference is not followed.
   *
   * @param base the file that holds the reference
   * @param reference the value of {@code href}: a URI with a fragment
   * @return empty if it may be followed
   */
  Optional<String> refusal(URI base, String reference) {
    URI target;
    try {
      target = URI.createURI(reference).trimFragment();
    } catch (IllegalArgumentException e) {
      return Optional.of("`" + reference + "` is not a URI.");
    }
    if (target.isEmpty() || isKnownMetamodel(target) || Uml.isLibrary(target)) {
      return Optional.empty();
    }
    if (target.scheme() != null && !target.isFile()) {
      return Optional.of(
          "The reference `" + reference + "` names the scheme `" + target.scheme() + "`.");
    }
    if (target.hasAuthority() && !target.authority().isEmpty()) {
      return Optional.of("The reference `" + reference + "` names another machine.");
    }
    URI file = target.resolve(base);
    if (followed.contains(file) || isInside(file)) {
      followed.add(file);
      return Optional.empty();
    }
    return Optional.of("The reference `" + reference + "` leaves the folders of the given files.");
  }

  boolean isKnownMetamodel(URI target) {
    return registry.containsKey(target.toString());
  }

  /** Returns whether a file URI lies in the project's folders, symbolic links followed. */
  boolean isInside(URI file) {
    if (!file.isFile()) {
      return false;
    }
    try {
      Path real = realPath(Path.of(file.toFileString()));
      return roots.stream().anyMatch(root -> real.startsWith(root.real));
    } catch (InvalidPathException e) {
      return false;
    }
  }

  /** Returns the real path of the longest existing prefix, with the rest as given. */
  static Path realPath(Path path) {
    Path absolute = path.toAbsolutePath().normalize();
    for (Path existing = absolute; existing != null; existing = existing.getParent()) {
      if (Files.exists(existing, LinkOption.NOFOLLOW_LINKS)) {
        try {
          return existing.toRealPath().resolve(existing.relativize(absolute)).normalize();
        } catch (IOException e) {
          return absolute;
        }
      }
    }
    return absolute;
  }
}

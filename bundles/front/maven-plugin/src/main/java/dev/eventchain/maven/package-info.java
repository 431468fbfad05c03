/** The goals of the Maven plugin. */
package dev.eventchain.maven;

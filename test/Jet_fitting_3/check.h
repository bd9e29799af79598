// Copyright (c) 2026 The Jet_fitting_3 authors.
//
// This file is part of Jet_fitting_3, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEST_JET_FITTING_3_CHECK_H
#define CGAL_TEST_JET_FITTING_3_CHECK_H

#include <exception>
#include <initializer_list>
#include <iostream>
#include <sstream>
#include <string>

// Checks that survive NDEBUG. A failed check prints both numbers and the program goes on;
// main() ends with `return test::result();`. Every comparison is written so that NaN fails it.
namespace test {

inline int& checks()
{
  static int count = 0;
  return count;
}
inline int& failures()
{
  static int count = 0;
  return count;
}

template <class T>
std::string text(const T& value)
{
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

inline bool record(bool passed, const std::string& what, const std::string& found)
{
  ++checks();
  if (!passed) {
    ++failures();
    std::cout << "FAILED " << what << ": " << found << std::endl;
  }
  return passed;
}

inline bool check_true(bool condition, const std::string& what) { return record(condition, what, "is false"); }

template <class T, class U>
bool check_equal(const T& value, const U& expected, const std::string& what)
{
  return record(value == expected, what, text(value) + " should equal " + text(expected));
}

template <class T, class U>
bool check_le(const T& value, const U& bound, const std::string& what)
{
  return record(value <= bound, what, text(value) + " should be at most " + text(bound));
}

template <class T, class U>
bool check_ge(const T& value, const U& bound, const std::string& what)
{
  return record(value >= bound, what, text(value) + " should be at least " + text(bound));
}

// |value - expected| <= tolerance, an absolute tolerance.
template <class T, class U, class V>
bool check_near(const T& value, const U& expected, const V& tolerance, const std::string& what)
{
  const auto difference = value - expected;
  return record(difference <= tolerance && -difference <= tolerance, what,
                text(value) + " should be " + text(expected) + " within " + text(tolerance));
}

// The call throws an Exception whose message holds every one of the given words.
template <class Exception, class Call>
bool check_throws(Call call, std::initializer_list<std::string> words, const std::string& what)
{
  try {
    call();
  } catch (const Exception& e) {
    const std::string message = e.what();
    for (const std::string& word : words)
      if (message.find(word) == std::string::npos)
        return record(false, what, "the message does not name '" + word + "': " + message);
    return record(true, what, "");
  } catch (const std::exception& e) {
    return record(false, what, std::string("another exception was thrown: ") + e.what());
  }
  return record(false, what, "nothing was thrown");
}

// The exit code: 0 only if something was checked and nothing failed.
inline int result()
{
  std::cout << checks() << " checks, " << failures() << " failed" << std::endl;
  return checks() > 0 && failures() == 0 ? 0 : 1;
}

} // namespace test

#endif // CGAL_TEST_JET_FITTING_3_CHECK_H

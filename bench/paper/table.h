// Tables as gnuplot and spreadsheets read them.

#ifndef GEODESIC_BENCH_PAPER_TABLE_H_
#define GEODESIC_BENCH_PAPER_TABLE_H_

#include <initializer_list>
#include <iostream>

namespace geodesic::paper {

// Prints rows of tab-separated cells, each as soon as it is known: runs take
// minutes.
class Table {
 public:
  Table(std::initializer_list<const char*> columns) {
    const char* separator = "";
    for (const char* column : columns) {
      std::cout << separator << column;
      separator = "\t";
    }
    std::cout << std::endl;
  }

  template <typename First, typename... Rest>
  void Add(const First& first, const Rest&... rest) {
    std::cout << first;
    ((std::cout << "\t" << rest), ...);
    std::cout << std::endl;
  }
};

}  // namespace geodesic::paper

#endif  // GEODESIC_BENCH_PAPER_TABLE_H_
